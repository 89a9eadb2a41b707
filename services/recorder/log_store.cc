#include "services/recorder/log_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "common/bus/bus.h"
#include "common/bus/run_log.h"

namespace cell::recorder {

namespace {

int NextNumber(const std::filesystem::path& run_dir) {
  int number = 1;
  for (const auto& log : LogsOf(run_dir)) {
    const std::string name = log.stem().string();  // cell-0001
    const size_t dash = name.rfind('-');
    if (dash != std::string::npos) {
      number = std::max(number, std::atoi(name.c_str() + dash + 1) + 1);
    }
  }
  return number;
}

}  // namespace

std::filesystem::path ClaimLogName(const std::filesystem::path& run_dir) {
  for (int number = NextNumber(run_dir);; ++number) {
    const auto path = run_dir / fmt::format("cell-{:04}.lcmlog", number);
    if (std::FILE* file = std::fopen(path.c_str(), "wx")) {
      std::fclose(file);
      return path;
    }
    if (errno != EEXIST) {
      throw std::runtime_error(fmt::format(
          "{}: cannot be created: {}", path.string(), std::strerror(errno)));
    }
  }
}

LogStore::LogStore(const std::filesystem::path& run_dir) {
  if (!run_dir.empty()) writer_.emplace(ClaimLogName(run_dir));
}

void LogStore::Append(const std::vector<Message>& messages) {
  if (!writer_ || messages.empty()) return;
  for (const Message& message : messages) {
    writer_->Write(int64_t{message.tick} * kTickUs, message.channel,
                   *message.bytes);
  }
  writer_->Flush();
}

}  // namespace cell::recorder
