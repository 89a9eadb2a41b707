#include "services/recorder/recorder.h"

#include <fmt/format.h>

#include <algorithm>

#include "cell/alert_t.hpp"
#include "cell/tick_t.hpp"
#include "common/bus/decode.h"
#include "services/recorder/live_recorder.h"

namespace cell::recorder {

Recorder::Recorder(Bus& bus, const std::filesystem::path& run_dir)
    : bus_(bus), store_(run_dir) {
  bus_.SubscribeAll(
      [this](const std::string& channel, std::span<const uint8_t> bytes) {
        OnMessage(channel, bytes);
      });
  bus_.Every(1, 0,
             [this] { store_.Append(order_.TakeBefore(complete_before_)); });
}

void Recorder::OnMessage(const std::string& channel,
                         std::span<const uint8_t> bytes) {
  const auto message =
      MessageFromWire(channel, Bytes(bytes.begin(), bytes.end()));
  if (!message) return;  // the manifest names none so short
  if (channel == kTickChannel) {
    OnTick(*message);
  } else {
    order_.Put(*message);
  }
}

void Recorder::OnTick(const Message& message) {
  const auto tick = Decode<tick_t>(message);
  if (!tick) return;
  const int32_t k = tick->header.tick;
  const bool is_joining = is_first_tick_;
  is_first_tick_ = false;
  if (is_joining && k > 0) {
    // What the clock published in the tick of joining was not received.
    const auto self =
        std::find_if(tick->joined.begin(), tick->joined.end(),
                     [](const joined_t& j) { return j.name == "recorder"; });
    const bool is_reborn = self != tick->joined.end() && self->death_tick >= 0;
    ReportGap(is_reborn ? std::max(self->death_tick - 1, 0) : 0, k);
  }
  order_.Put(message);
  // Of the last tick only the clock's messages count: they are all there once
  // this tick's have been handled.
  complete_before_ = tick->is_last ? k + 1 : k;
}

void Recorder::ReportGap(int32_t from, int32_t to) {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::WARNING;
  alert.cause = alert_t::MISSED_TICKS;
  alert.text = fmt::format("the log lacks ticks {} to {}", from, to);
  bus_.Publish("ALERT", alert);
}

std::unique_ptr<Service> MakeRecorder(Bus& bus, const Deployment& deployment) {
  const RotatingLog::Params params =
      RotatingLog::ParamsFromConfig(deployment.ForService("recorder"));
  if (!deployment.is_live) {
    return std::make_unique<Recorder>(bus, deployment.run_dir);
  }
  return std::make_unique<LiveRecorder>(bus, deployment.run_dir, params);
}

}  // namespace cell::recorder
