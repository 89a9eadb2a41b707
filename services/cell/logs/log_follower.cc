#include "services/cell/logs/log_follower.h"

#include <utility>

#include "common/bus/run_log.h"

namespace cell::cli {

std::optional<Message> LogFollower::Next() {
  while (reader_ || OpenNext()) {
    while (auto event = reader_->Next()) {
      auto message = MessageFromWire(event->channel, std::move(event->bytes));
      if (message) return *message;
    }
    if (!OpenNext()) return std::nullopt;
  }
  return std::nullopt;
}

bool LogFollower::OpenNext() {
  const auto logs = LogsOf(run_dir_);
  if (num_opened_ >= logs.size()) return false;
  reader_.emplace(logs[num_opened_++]);
  return true;
}

}  // namespace cell::cli
