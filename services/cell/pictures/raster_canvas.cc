#include "services/cell/pictures/raster_canvas.h"

#include <algorithm>
#include <cmath>

#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

constexpr int kTextScale = 2;
constexpr Canvas::Colour kWhite = {255, 255, 255};

}  // namespace

RasterCanvas::RasterCanvas(int width, int height) : image_{width, height, {}} {
  image_.pixels.assign(static_cast<size_t>(width) * static_cast<size_t>(height),
                       kWhite);
}

void RasterCanvas::Put(int x, int y, const Colour& colour) {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
  image_.pixels[static_cast<size_t>(y) * static_cast<size_t>(image_.width) +
                static_cast<size_t>(x)] = colour;
}

void RasterCanvas::Rectangle(int x, int y, int width, int height,
                             const Colour& fill) {
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) Put(column, row, fill);
  }
}

void RasterCanvas::Line(int x1, int y1, int x2, int y2, int width,
                        const Colour& colour) {
  const int steps = std::max({std::abs(x2 - x1), std::abs(y2 - y1), 1});
  for (int i = 0; i <= steps; ++i) {
    Rectangle(x1 + (x2 - x1) * i / steps - width / 2,
              y1 + (y2 - y1) * i / steps - width / 2, width, width, colour);
  }
}

void RasterCanvas::Disc(int x, int y, int radius, const Colour& fill) {
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (dx * dx + dy * dy <= radius * radius) Put(x + dx, y + dy, fill);
    }
  }
}

void RasterCanvas::Text(int x, int y, const std::string& text) {
  const auto [width, height] = TextSize(text, kTextScale);
  DrawText(text, x, y - height / 2, kTextScale, &image_);
}

void RasterCanvas::CentredText(int x, int y, const std::string& text) {
  const auto [width, height] = TextSize(text, kTextScale);
  DrawText(text, x - width / 2, y - height / 2, kTextScale, &image_);
}

void RasterCanvas::Picture(int x, int y, const RgbImage& picture) {
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      Put(x + column, y + row,
          picture.pixels[static_cast<size_t>(row) *
                             static_cast<size_t>(picture.width) +
                         static_cast<size_t>(column)]);
    }
  }
}

}  // namespace cell::cli
