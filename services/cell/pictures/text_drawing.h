#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/imaging/rgb_image.h"

namespace cell::cli {

/// Size [px] that DrawText() takes up.
std::array<int, 2> TextSize(const std::string& text, int scale);

/// Writes ASCII text on a background of its own, its left upper corner in
/// (column, row); what lies outside the picture is cut off. @param scale  of
/// letters 7 pixels high
void DrawText(const std::string& text, int column, int row, int scale,
              RgbImage* picture);

}  // namespace cell::cli
