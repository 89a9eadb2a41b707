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

  /// What it sees as of now; nothing if it has seen nothing new.
  /// @throws std::runtime_error that says what is broken.
  virtual std::optional<RgbdFrame> Take() = 0;
};

}  // namespace cell::camera_set
