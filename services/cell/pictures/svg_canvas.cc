#include "services/cell/pictures/svg_canvas.h"

#include <fmt/format.h>
#include <lodepng.h>

#include <stdexcept>
#include <string_view>
#include <vector>

namespace cell::cli {
namespace {

std::string Hex(const Canvas::Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

// RFC 4648.
std::string Base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < count ? bytes[i + k] : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::vector<unsigned char> PngOf(const RgbImage& picture) {
  std::vector<unsigned char> pixels;
  pixels.reserve(3 * picture.pixels.size());
  for (const auto& pixel : picture.pixels) {
    pixels.insert(pixels.end(), pixel.begin(), pixel.end());
  }
  std::vector<unsigned char> png;
  const unsigned error =
      lodepng::encode(png, pixels, static_cast<unsigned>(picture.width),
                      static_cast<unsigned>(picture.height), LCT_RGB, 8);
  if (error != 0) throw std::runtime_error(lodepng_error_text(error));
  return png;
}

}  // namespace

SvgCanvas::SvgCanvas(int width, int height)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                        "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
                        "{1}\" font-family=\"sans-serif\" "
                        "font-size=\"16\">\n",
                        width, height)) {
  Rectangle(0, 0, width, height, {255, 255, 255});
}

void SvgCanvas::Rectangle(int x, int y, int width, int height,
                          const Colour& fill) {
  text_ += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x,
      y, width, height, Hex(fill));
}

void SvgCanvas::Line(int x1, int y1, int x2, int y2, int width,
                     const Colour& colour) {
  text_ += fmt::format(
      "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" "
      "stroke-width=\"{}\"/>\n",
      x1, y1, x2, y2, Hex(colour), width);
}

void SvgCanvas::Disc(int x, int y, int radius, const Colour& fill) {
  text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n",
                       x, y, radius, Hex(fill));
}

void SvgCanvas::Text(int x, int y, const std::string& text) {
  AddText(x, y, "start", text);
}

void SvgCanvas::CentredText(int x, int y, const std::string& text) {
  AddText(x, y, "middle", text);
}

void SvgCanvas::AddText(int x, int y, const char* anchor,
                        const std::string& text) {
  text_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" "
      "dominant-baseline=\"central\">{}</text>\n",
      x, y, anchor, Escaped(text));
}

void SvgCanvas::Picture(int x, int y, const RgbImage& picture) {
  text_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      x, y, picture.width, picture.height, Base64(PngOf(picture)));
}

}  // namespace cell::cli
