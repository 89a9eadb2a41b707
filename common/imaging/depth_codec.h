#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/imaging/depth_image.h"

namespace cell {

/// Depth without loss: rgbd_frame_t's PLANAR_ZSTD. Depth is planar nearly
/// everywhere, so that little more than its rounding remains: on the cell's
/// views three quarters of PNG's length in a fifteenth of its time
/// (imaging_bench).
/// @throws std::invalid_argument if the counts do not fill a picture.
std::vector<uint8_t> EncodeDepth(const DepthImage& image);

/// Nothing if the bytes are not those of a picture of this size. Needs no more
/// memory than such a picture does, whatever the bytes say.
std::optional<DepthImage> DecodeDepth(std::span<const uint8_t> bytes, int width,
                                      int height);

}  // namespace cell
