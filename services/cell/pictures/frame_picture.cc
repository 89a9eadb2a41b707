#include "services/cell/pictures/frame_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

/// What the grey means: at the foot of the picture from the furthest to the
/// nearest.
void DrawScale(int nearest, int furthest, double unit, RgbImage* picture) {
  const auto metres = [&](int count) {
    return fmt::format("{:.2f} m", count * unit);
  };
  constexpr int kScale = 2;
  constexpr int kEdge = 8;
  const std::string low = "dark " + metres(furthest);
  const std::string high = "bright " + metres(nearest);
  const auto [width, height] = TextSize(high, kScale);
  const int row = picture->height - height - kEdge;
  DrawText(low, kEdge, row, kScale, picture);
  DrawText(high, picture->width - width - kEdge, row, kScale, picture);
}

}  // namespace

RgbImage GreyOfDepth(const RgbdFrame& frame) {
  const DepthImage& depth = frame.depth;
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
  if (nearest <= furthest) {
    DrawScale(nearest, furthest, frame.depth_unit, &picture);
  }
  return picture;
}

}  // namespace cell::cli
