#pragma once

#include <filesystem>

#include "common/imaging/depth_image.h"
#include "common/imaging/rgb_image.h"

namespace cell {

/// 8 bits a channel. @throws std::runtime_error naming the file if it cannot be
/// written.
void WritePng(const std::filesystem::path& path, const RgbImage& image);
/// 16 bits of grey. @throws as above.
void WritePng(const std::filesystem::path& path, const DepthImage& image);

/// Any PNG, as 8-bit colour. @throws std::runtime_error naming the file if it
/// is missing, damaged or larger than kMaxPixels.
RgbImage ReadColourPng(const std::filesystem::path& path);
/// @throws as above, and if it is not 16-bit grey.
DepthImage ReadDepthPng(const std::filesystem::path& path);

}  // namespace cell
