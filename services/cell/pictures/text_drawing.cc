#include "services/cell/pictures/text_drawing.h"

#include <algorithm>
#include <cstring>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace cell::cli {
namespace {

using Colour = std::array<uint8_t, 3>;

constexpr Colour kInk = {20, 20, 20};
constexpr Colour kBackground = {250, 250, 250};
constexpr int kMargin = 2;  // of the background, before scaling

/// The corners of a rectangle that the font is made of, as it writes them.
struct Corner {
  float x, y, z;
  uint8_t colour[4];
};
using Quad = std::array<Corner, 4>;

/// Of the text in pixels before scaling.
std::vector<Quad> QuadsOf(const std::string& text) {
  constexpr size_t kMaxQuadsOfLetter = 70;
  std::vector<Quad> quads((text.size() + 1) * kMaxQuadsOfLetter);
  std::string letters = text;  // the font takes no const
  const int num =
      stb_easy_font_print(0, 0, letters.data(), nullptr, quads.data(),
                          static_cast<int>(quads.size() * sizeof(Quad)));
  quads.resize(static_cast<size_t>(num));
  return quads;
}

void Fill(int left, int top, int right, int bottom, const Colour& colour,
          RgbImage* picture) {
  for (int row = std::max(top, 0); row < std::min(bottom, picture->height);
       ++row) {
    for (int column = std::max(left, 0);
         column < std::min(right, picture->width); ++column) {
      picture->pixels[static_cast<size_t>(row) *
                          static_cast<size_t>(picture->width) +
                      static_cast<size_t>(column)] = colour;
    }
  }
}

}  // namespace

std::array<int, 2> TextSize(const std::string& text, int scale) {
  std::string letters = text;
  constexpr int kHeight = 8;
  return {scale * (stb_easy_font_width(letters.data()) + 2 * kMargin),
          scale * (kHeight + 2 * kMargin)};
}

void DrawText(const std::string& text, int column, int row, int scale,
              RgbImage* picture) {
  const auto [width, height] = TextSize(text, scale);
  Fill(column, row, column + width, row + height, kBackground, picture);
  const auto at = [&](float units) {
    return static_cast<int>(units) * scale + kMargin * scale;
  };
  for (const Quad& quad : QuadsOf(text)) {
    Fill(column + at(quad[0].x), row + at(quad[0].y), column + at(quad[2].x),
         row + at(quad[2].y), kInk, picture);
  }
}

}  // namespace cell::cli
