#pragma once

#include <filesystem>

#include "common/rendering/render_image.h"

namespace cell {

/// @throws std::runtime_error naming the file if it cannot be written.
void WritePng(const std::filesystem::path& path, const RgbImage& image);

}  // namespace cell
