#include "services/recorder/live_recorder.h"

#include <fmt/format.h>

#include <utility>

#include "cell/alert_t.hpp"

namespace cell::recorder {
namespace {

constexpr int32_t kRetryTicks = 125;

}  // namespace

LiveRecorder::LiveRecorder(Bus& bus, const std::filesystem::path& run_dir,
                           const RotatingLog::Params& params)
    : bus_(bus), log_(run_dir, params) {
  bus_.SubscribeAll(
      [this](const std::string& channel, std::span<const uint8_t> bytes) {
        const auto message =
            MessageFromWire(channel, Bytes(bytes.begin(), bytes.end()));
        if (message) messages_.push_back(*message);
      });
  bus_.Every(1, 0, [this] { OnTick(); });
}

void LiveRecorder::OnTick() {
  const std::vector<Message> messages = std::exchange(messages_, {});
  const auto num_messages = static_cast<int64_t>(messages.size());
  if (num_missed_ > 0 && bus_.tick() < retry_tick_) {
    num_missed_ += num_messages;
    return;
  }
  const auto failure = log_.Append(messages);
  if (failure) {
    if (num_missed_ == 0) {
      Publish(alert_t::ERROR, "recording has stopped: " + *failure);
    }
    num_missed_ += num_messages;
    retry_tick_ = bus_.tick() + kRetryTicks;
  } else if (num_missed_ > 0 && num_messages > 0) {
    Publish(alert_t::WARNING,
            fmt::format("recording again; the log lacks {} messages",
                        std::exchange(num_missed_, 0)));
  }
}

void LiveRecorder::Publish(int8_t level, const std::string& text) {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = level;
  alert.cause = alert_t::DISK_FULL;
  alert.text = text;
  bus_.Publish("ALERT", alert);
}

}  // namespace cell::recorder
