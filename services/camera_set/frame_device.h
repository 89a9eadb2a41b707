#pragma once

#include <optional>

#include "common/imaging/rgbd_frame.h"

namespace cell::camera_set {

/// Where the pictures of a camera set come from.
class FrameDevice {
 public:
  FrameDevice() = default;
  FrameDevice(const FrameDevice&) = delete;
  FrameDevice& operator=(const FrameDevice&) = delete;
  virtual ~FrameDevice() = default;

  /// The newest frame; nullopt if there is no new one. @throws
  /// std::runtime_error that names what is broken.
  virtual std::optional<RgbdFrame> Capture() = 0;
};

}  // namespace cell::camera_set
