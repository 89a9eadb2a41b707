#include "services/camera_set/recorded_device.h"

#include "cell/alert_t.hpp"
#include "cell/tick_t.hpp"
#include "common/bus/message.h"

namespace cell::camera_set {

RecordedDevice::RecordedDevice(Bus& bus, const Params& params)
    : bus_(bus),
      camera_(params.camera),
      X_WC_(params.X_WC),
      frames_(params.folder, params.is_loop) {
  // Only messages activate a slow service: TICK is one that always comes.
  bus.Subscribe<tick_t>(
      kTickChannel, [](const tick_t&) {}, 1);
}

std::optional<RgbdFrame> RecordedDevice::Capture() {
  auto frame = frames_.Next();
  if (!frame) return std::nullopt;
  if (!frames_.remark().empty()) PublishRemark();
  frame->utime = bus_.now();
  frame->camera = camera_;
  frame->view.X_WC = X_WC_;
  return frame;
}

void RecordedDevice::PublishRemark() {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::WARNING;
  alert.cause = alert_t::BAD_INPUT;
  alert.text = frames_.remark();
  bus_.Publish("ALERT", alert);
}

}  // namespace cell::camera_set
