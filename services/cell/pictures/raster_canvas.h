#pragma once

#include <string>

#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// Draws into a picture, white at first; what lies outside is cut off.
class RasterCanvas final : public Canvas {
 public:
  RasterCanvas(int width, int height);

  void Rectangle(int x, int y, int width, int height,
                 const Colour& fill) override;
  void Line(int x1, int y1, int x2, int y2, int width,
            const Colour& colour) override;
  void Disc(int x, int y, int radius, const Colour& fill) override;
  void Text(int x, int y, const std::string& text) override;
  void CentredText(int x, int y, const std::string& text) override;
  void Picture(int x, int y, const RgbImage& picture) override;

  const RgbImage& image() const { return image_; }

 private:
  void Put(int x, int y, const Colour& colour);

  RgbImage image_;
};

}  // namespace cell::cli
