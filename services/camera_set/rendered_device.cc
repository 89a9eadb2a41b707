#include "services/camera_set/rendered_device.h"

#include <utility>

namespace cell::camera_set {

RenderedDevice::RenderedDevice(Bus& bus, std::vector<RenderBody> bodies,
                               RenderedView::Params params)
    : view_(std::move(bodies), std::move(params)) {
  bus.Subscribe<truth_poses_t>(
      "TRUTH_POSES",
      [this](const truth_poses_t& message) {
        auto truth = TruthFromMessage(message);
        if (!truth) return false;
        truth_ = *std::move(truth);
        return true;
      },
      1);
}

std::optional<RgbdFrame> RenderedDevice::Capture() {
  const auto truth = std::exchange(truth_, std::nullopt);
  if (!truth) return std::nullopt;
  return view_.Capture(*truth);
}

}  // namespace cell::camera_set
