#pragma once

#include <string>

#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// Writes shapes as SVG; pictures are embedded as PNG.
class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(int width, int height);

  void Rectangle(int x, int y, int width, int height,
                 const Colour& fill) override;
  void Line(int x1, int y1, int x2, int y2, int width,
            const Colour& colour) override;
  void Disc(int x, int y, int radius, const Colour& fill) override;
  void Text(int x, int y, const std::string& text) override;
  void CentredText(int x, int y, const std::string& text) override;
  /// @throws std::runtime_error if the picture cannot be compressed.
  void Picture(int x, int y, const RgbImage& picture) override;

  /// The whole file.
  std::string ToText() const { return text_ + "</svg>\n"; }

 private:
  void AddText(int x, int y, const char* anchor, const std::string& text);

  std::string text_;
};

}  // namespace cell::cli
