#include "common/rendering/render_image.h"

#include <algorithm>

#include "common/rendering/id_colours.h"

namespace cell {
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
  const int32_t last =
      body_id.empty() ? kNobody : *std::ranges::max_element(body_id);
  const auto colours = DistinctColours(static_cast<size_t>(last + 1));
  for (const int32_t id : body_id) {
    picture.pixels.push_back(id == kNobody ? std::array<uint8_t, 3>{0, 0, 0}
                                           : colours[static_cast<size_t>(id)]);
  }
  return picture;
}

}  // namespace cell
