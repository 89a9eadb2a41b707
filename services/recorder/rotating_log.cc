#include "services/recorder/rotating_log.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/run_log.h"
#include "services/recorder/log_store.h"

namespace cell::recorder {
namespace {

/// What an event takes beside its bytes, about.
constexpr int64_t kEventBytes = 48;

}  // namespace

RotatingLog::Params RotatingLog::ParamsFromConfig(const Config& config) {
  const auto bytes = [&config](const char* key) {
    return int64_t{config.Integer(key, 1, 1 << 30)} << 20;
  };
  const Params params{bytes("rotate_mb"), bytes("keep_mb"),
                      bytes("min_free_mb")};
  config.Finish();
  return params;
}

RotatingLog::RotatingLog(std::filesystem::path run_dir, const Params& params)
    : run_dir_(std::move(run_dir)), params_(params) {}

std::optional<std::string> RotatingLog::Append(
    const std::vector<Message>& messages) {
  if (run_dir_.empty() || messages.empty()) return std::nullopt;
  try {
    if (auto lack = LackOfRoom()) {
      writer_.reset();
      return lack;
    }
    if (!writer_ || num_bytes_ >= params_.file_bytes) Open();
    for (const Message& message : messages) {
      writer_->Write(int64_t{message.tick} * kTickUs, message.channel,
                     *message.bytes);
      num_bytes_ += static_cast<int64_t>(message.bytes->size()) + kEventBytes;
    }
    writer_->Flush();
    return std::nullopt;
  } catch (const std::exception& e) {
    writer_.reset();
    return e.what();
  }
}

std::optional<std::string> RotatingLog::LackOfRoom() const {
  const auto space = std::filesystem::space(run_dir_);
  if (static_cast<int64_t>(space.available) >= params_.free_bytes) {
    return std::nullopt;
  }
  return fmt::format(
      "{}: only {} MB are left on the disk, {} must stay free "
      "(recorder.yaml:min_free_mb)",
      run_dir_.string(), space.available >> 20, params_.free_bytes >> 20);
}

void RotatingLog::Open() {
  writer_.reset();
  writer_.emplace(ClaimLogName(run_dir_));
  num_bytes_ = 0;
  RemoveOldest();
}

void RotatingLog::RemoveOldest() const {
  const auto logs = LogsOf(run_dir_);
  int64_t total = 0;
  for (auto it = logs.rbegin(); it != logs.rend(); ++it) {
    total += static_cast<int64_t>(std::filesystem::file_size(*it));
    if (total > params_.total_bytes) std::filesystem::remove(*it);
  }
}

}  // namespace cell::recorder
