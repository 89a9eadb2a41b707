#include "common/rendering/render_image.h"

#include <array>
#include <cmath>
#include <numbers>

namespace cell {
namespace {

/// Hues apart by the golden angle: neighbours in number differ in colour.
std::array<uint8_t, 3> ColourOfId(int32_t id) {
  if (id == RenderImage::kNobody) return {0, 0, 0};
  const double hue = 2.39996322972865332 * (id + 1);
  std::array<uint8_t, 3> colour{};
  for (size_t i = 0; i < 3; ++i) {
    const double phase =
        hue + static_cast<double>(i) * 2 * std::numbers::pi / 3;
    const double value = 150 + 100 * std::cos(phase);
    colour[i] = static_cast<uint8_t>(std::lround(value));
  }
  return colour;
}

}  // namespace

std::map<int32_t, int> RenderImage::NumPixels() const {
  std::map<int32_t, int> num_pixels;
  for (const int32_t id : body_id) {
    if (id != kNobody) ++num_pixels[id];
  }
  return num_pixels;
}

RgbImage RenderImage::IdPicture() const {
  RgbImage picture{colour.width, colour.height, {}};
  picture.pixels.reserve(body_id.size());
  for (const int32_t id : body_id) picture.pixels.push_back(ColourOfId(id));
  return picture;
}

}  // namespace cell
