#include "services/recorder/log_store.h"

#include <fmt/format.h>

#include "common/bus/bus.h"

namespace cell {

LogStore::LogStore(const std::filesystem::path& run_dir) {
  if (run_dir.empty()) return;
  for (int number = 1;; ++number) {
    const auto path = run_dir / fmt::format("cell-{:04}.lcmlog", number);
    if (std::filesystem::exists(path)) continue;
    writer_.emplace(path);
    return;
  }
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
