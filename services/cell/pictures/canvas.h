#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/imaging/rgb_image.h"

namespace cell::cli {

/// What a figure is drawn on: pixels, or a file of shapes. Lengths in pixels, x
/// to the right and y down from the top left corner; later shapes cover earlier
/// ones.
class Canvas {
 public:
  using Colour = std::array<uint8_t, 3>;

  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  virtual void Rectangle(int x, int y, int width, int height,
                         const Colour& fill) = 0;
  virtual void Line(int x1, int y1, int x2, int y2, int width,
                    const Colour& colour) = 0;
  virtual void Disc(int x, int y, int radius, const Colour& fill) = 0;
  /// The middle of its left edge is at (x, y).
  virtual void Text(int x, int y, const std::string& text) = 0;
  /// Its middle is at (x, y).
  virtual void CentredText(int x, int y, const std::string& text) = 0;
  virtual void Picture(int x, int y, const RgbImage& picture) = 0;
};

}  // namespace cell::cli
