#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/imaging/rgb_image.h"

namespace cell {

/// JPEG of a quality of 1 to 100 [%].
/// @throws std::invalid_argument if the pixels do not fill a picture.
std::vector<uint8_t> EncodeColour(const RgbImage& image, int quality);

/// Nothing if the bytes are not a whole JPEG of a picture of this size: what
/// they say of themselves is looked at before anything is decoded.
std::optional<RgbImage> DecodeColour(std::span<const uint8_t> bytes, int width,
                                     int height);

}  // namespace cell
