#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "common/imaging/rgb_image.h"

namespace cell {

/// What a camera sees, row by row from the top left.
struct RenderImage {
  static constexpr int32_t kNobody = -1;

  RgbImage colour;
  std::vector<float> depth;      ///< [m] along z of C; 0 where nothing is
  std::vector<int32_t> body_id;  ///< index in RenderScene::bodies(), kNobody

  size_t Index(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(colour.width) +
           static_cast<size_t>(column);
  }
  /// Of each body that is seen.
  std::map<int32_t, int> NumPixels() const;
  /// Every body in a colour of its own, by its index; black elsewhere.
  RgbImage IdPicture() const;
};

}  // namespace cell
