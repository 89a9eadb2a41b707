#include "services/recorder/log_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "common/bus/bus.h"
#include "common/bus/run_log.h"

namespace cell {

std::filesystem::path FreeLogName(const std::filesystem::path& run_dir) {
  int number = 1;
  for (const auto& log : LogsOf(run_dir)) {
    const std::string name = log.stem().string();  // cell-0001
    const size_t dash = name.rfind('-');
    if (dash != std::string::npos) {
      number = std::max(number, std::atoi(name.c_str() + dash + 1) + 1);
    }
  }
  return run_dir / fmt::format("cell-{:04}.lcmlog", number);
}

LogStore::LogStore(const std::filesystem::path& run_dir) {
  if (!run_dir.empty()) writer_.emplace(FreeLogName(run_dir));
}

void LogStore::Append(const std::vector<Message>& messages) {
  if (!writer_ || messages.empty()) return;
  for (const Message& message : messages) {
    writer_->Write(int64_t{message.tick} * kTickUs, message.channel,
                   *message.bytes);
  }
  writer_->Flush();
}

}  // namespace cell
