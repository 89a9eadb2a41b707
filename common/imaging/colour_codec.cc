#include "common/imaging/colour_codec.h"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>
#include <stdexcept>

#include "common/imaging/depth_image.h"

namespace cell {
namespace {

struct HandleDeleter {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, HandleDeleter>;

constexpr int kBytesPerPixel = 3;

}  // namespace

std::vector<uint8_t> EncodeColour(const RgbImage& image, int quality) {
  if (!IsPictureSize(image.width, image.height) ||
      image.pixels.size() != static_cast<size_t>(image.width) *
                                 static_cast<size_t>(image.height)) {
    throw std::invalid_argument(fmt::format("{} pixels in a picture of {} x {}",
                                            image.pixels.size(), image.width,
                                            image.height));
  }
  const Handle handle(tjInitCompress());
  std::vector<uint8_t> bytes(tjBufSize(image.width, image.height, TJSAMP_420));
  unsigned char* begin = bytes.data();
  unsigned long size = bytes.size();
  const int error = tjCompress2(
      handle.get(), image.pixels.front().data(), image.width,
      kBytesPerPixel * image.width, image.height, TJPF_RGB, &begin, &size,
      TJSAMP_420, quality, TJFLAG_NOREALLOC | TJFLAG_ACCURATEDCT);
  if (error != 0) throw std::runtime_error(tjGetErrorStr2(handle.get()));
  bytes.resize(size);
  return bytes;
}

std::optional<RgbImage> DecodeColour(std::span<const uint8_t> bytes, int width,
                                     int height) {
  if (!IsPictureSize(width, height)) return std::nullopt;
  const Handle handle(tjInitDecompress());
  int its_width = 0;
  int its_height = 0;
  int sampling = 0;
  int colour_space = 0;
  if (tjDecompressHeader3(handle.get(), bytes.data(), bytes.size(), &its_width,
                          &its_height, &sampling, &colour_space) != 0 ||
      its_width != width || its_height != height) {
    return std::nullopt;
  }
  RgbImage image{width, height, {}};
  image.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
  // A truncated picture is a warning; many scans would cost time without end.
  const int error = tjDecompress2(
      handle.get(), bytes.data(), bytes.size(), image.pixels.front().data(),
      width, kBytesPerPixel * width, height, TJPF_RGB,
      TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT);
  if (error != 0) return std::nullopt;
  return image;
}

}  // namespace cell
