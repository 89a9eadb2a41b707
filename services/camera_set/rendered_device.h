#pragma once

#include <optional>

#include "common/bus/bus.h"
#include "services/camera_set/frame_device.h"
#include "services/camera_set/rendered_view.h"

namespace cell::camera_set {

/// TRUTH_POSES -> pictures: stands in for the device in the testbed.
class RenderedDevice final : public FrameDevice {
 public:
  /// `bus` must outlive this object.
  RenderedDevice(Bus& bus, std::vector<RenderBody> bodies,
                 RenderedView::Params params);

  std::optional<RgbdFrame> Capture() override;

 private:
  RenderedView view_;
  std::optional<TruthPoses> truth_;  // not yet seen
};

}  // namespace cell::camera_set
