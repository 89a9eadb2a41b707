#include "services/cell/pictures/frame_picture.h"

#include <algorithm>

namespace cell::cli {

RgbImage GreyOfDepth(const DepthImage& depth) {
  int nearest = 65535;
  int furthest = 1;
  for (const int count : depth.counts) {
    if (count == 0) continue;
    nearest = std::min(nearest, count);
    furthest = std::max(furthest, count);
  }
  constexpr int kDarkest = 30;
  const int range = std::max(furthest - nearest, 1);
  RgbImage picture{depth.width, depth.height, {}};
  picture.pixels.reserve(depth.counts.size());
  for (const int count : depth.counts) {
    const int grey =
        count == 0 ? 0
                   : kDarkest + (255 - kDarkest) * (furthest - count) / range;
    const auto value = static_cast<uint8_t>(grey);
    picture.pixels.push_back({value, value, value});
  }
  return picture;
}

}  // namespace cell::cli
