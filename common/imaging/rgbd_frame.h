#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cell/rgbd_frame_t.hpp"
#include "common/imaging/camera.h"
#include "common/imaging/depth_image.h"
#include "common/imaging/rgb_image.h"

namespace cell {

/// What one camera set has seen at one moment.
struct RgbdFrame {
  int64_t utime = 0;         ///< of the exposure
  std::string camera;        ///< the set, e.g. "1"
  Camera view;               ///< of both pictures: its size is theirs
  double depth_unit = 1e-4;  ///< [m] of a count
  RgbImage colour;
  DepthImage depth;
};

/// The encoded message is at most `max_bytes` long: colour loses quality
/// [% of JPEG] step by step from `quality` on until it is. Nothing if it is
/// longer even so: depth loses nothing.
std::optional<rgbd_frame_t> FrameToMessage(const RgbdFrame& frame,
                                           int max_bytes, int quality);

/// Nothing if any of it cannot be: formats, sizes, numbers, bytes.
std::optional<RgbdFrame> FrameFromMessage(const rgbd_frame_t& message);

}  // namespace cell
