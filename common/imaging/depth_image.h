#pragma once

#include <cstdint>
#include <vector>

namespace cell {

/// Depths along the camera's z in counts of some unit, row by row from the top
/// left; 0 where nothing was measured.
struct DepthImage {
  int width = 0;
  int height = 0;
  std::vector<uint16_t> counts;
};

/// No picture that is read or decoded may have more pixels.
inline constexpr int64_t kMaxPixels = int64_t{1} << 21;

/// True for sizes that a picture can have.
constexpr bool IsPictureSize(int64_t width, int64_t height) {
  return width > 0 && height > 0 && width <= kMaxPixels &&
         height <= kMaxPixels && width * height <= kMaxPixels;
}

}  // namespace cell
