#include "common/imaging/png_file.h"

#include <fmt/format.h>
#include <lodepng.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/files/draft.h"

namespace cell {
namespace {

using FileBytes = std::vector<unsigned char>;

void Require(bool is_good, const std::filesystem::path& path,
             const std::string& what) {
  if (!is_good) throw std::runtime_error(path.string() + ": " + what);
}

void RequireNoError(unsigned error, const std::filesystem::path& path) {
  if (error != 0) Require(false, path, lodepng_error_text(error));
}

struct Png {
  int width = 0;
  int height = 0;
  bool is_deep_grey = false;
  FileBytes file;
};

/// True if nothing follows the last chunk; lodepng would not look.
bool EndsAsPng(const FileBytes& file) {
  constexpr std::array<unsigned char, 12> kEnd = {
      0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
  return file.size() >= kEnd.size() &&
         std::equal(kEnd.begin(), kEnd.end(), file.end() - kEnd.size());
}

/// Format and size of the file by its header.
Png Inspect(const std::filesystem::path& path) {
  Png png;
  RequireNoError(lodepng::load_file(png.file, path.string()), path);
  Require(EndsAsPng(png.file), path,
          "is cut off, or has bytes after its end: it should end with IEND");
  unsigned width = 0;
  unsigned height = 0;
  lodepng::State state;
  RequireNoError(lodepng_inspect(&width, &height, &state, png.file.data(),
                                 png.file.size()),
                 path);
  Require(IsPictureSize(width, height), path,
          fmt::format("is a picture of {} x {} pixels, more than {}", width,
                      height, kMaxPixels));
  png.width = static_cast<int>(width);
  png.height = static_cast<int>(height);
  png.is_deep_grey = state.info_png.color.colortype == LCT_GREY &&
                     state.info_png.color.bitdepth == 16;
  return png;
}

FileBytes Decode(const Png& png, const std::filesystem::path& path,
                 LodePNGColorType type, unsigned bits) {
  FileBytes bytes;
  unsigned width = 0;
  unsigned height = 0;
  RequireNoError(lodepng::decode(bytes, width, height, png.file, type, bits),
                 path);
  return bytes;
}

void Write(const std::filesystem::path& path, const FileBytes& bytes, int width,
           int height, LodePNGColorType type, unsigned bits) {
  lodepng::State state;
  state.info_raw.colortype = state.info_png.color.colortype = type;
  state.info_raw.bitdepth = state.info_png.color.bitdepth = bits;
  // It would write fewer bits where they are enough: no depth picture any more.
  state.encoder.auto_convert = 0;
  FileBytes file;
  RequireNoError(lodepng::encode(file, bytes, static_cast<unsigned>(width),
                                 static_cast<unsigned>(height), state),
                 path);
  WriteFile(path, {reinterpret_cast<const char*>(file.data()), file.size()});
}

}  // namespace

void WritePng(const std::filesystem::path& path, const RgbImage& image) {
  FileBytes bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const auto& pixel : image.pixels) {
    bytes.insert(bytes.end(), pixel.begin(), pixel.end());
  }
  Write(path, bytes, image.width, image.height, LCT_RGB, 8);
}

void WritePng(const std::filesystem::path& path, const DepthImage& image) {
  FileBytes bytes;  // big endian
  bytes.reserve(image.counts.size() * 2);
  for (const uint16_t count : image.counts) {
    bytes.push_back(static_cast<unsigned char>(count >> 8));
    bytes.push_back(static_cast<unsigned char>(count & 0xff));
  }
  Write(path, bytes, image.width, image.height, LCT_GREY, 16);
}

RgbImage ReadColourPng(const std::filesystem::path& path) {
  const Png png = Inspect(path);
  const FileBytes bytes = Decode(png, path, LCT_RGB, 8);
  RgbImage image{png.width, png.height, {}};
  image.pixels.reserve(bytes.size() / 3);
  for (size_t i = 0; i + 2 < bytes.size(); i += 3) {
    image.pixels.push_back({bytes[i], bytes[i + 1], bytes[i + 2]});
  }
  return image;
}

DepthImage ReadDepthPng(const std::filesystem::path& path) {
  const Png png = Inspect(path);
  Require(png.is_deep_grey, path, "is not a depth picture: 16 bits of grey");
  const FileBytes bytes = Decode(png, path, LCT_GREY, 16);
  DepthImage image{png.width, png.height, {}};
  image.counts.reserve(bytes.size() / 2);
  for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
    image.counts.push_back(static_cast<uint16_t>(bytes[i] << 8 | bytes[i + 1]));
  }
  return image;
}

}  // namespace cell
