#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cell {

/// An 8-bit sRGB picture, row by row from the top left.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::array<uint8_t, 3>> pixels;
};

}  // namespace cell
