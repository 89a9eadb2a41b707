#include "common/rendering/png_file.h"

#include <lodepng.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace cell {

void WritePng(const std::filesystem::path& path, const RgbImage& image) {
  std::vector<unsigned char> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const auto& pixel : image.pixels) {
    bytes.insert(bytes.end(), pixel.begin(), pixel.end());
  }
  const unsigned error =
      lodepng::encode(path.string(), bytes, static_cast<unsigned>(image.width),
                      static_cast<unsigned>(image.height), LCT_RGB);
  if (error != 0) {
    throw std::runtime_error(path.string() + ": " + lodepng_error_text(error));
  }
}

}  // namespace cell
