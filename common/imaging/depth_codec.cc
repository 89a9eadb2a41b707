#include "common/imaging/depth_codec.h"

#include <fmt/format.h>
#include <zstd.h>

#include <stdexcept>

namespace cell {
namespace {

// Higher levels take longer and save nothing on such data.
constexpr int kLevel = 1;

uint16_t Wrapped(int value) {
  return static_cast<uint16_t>(value);
}

/// Small numbers of either sign become small numbers.
uint16_t Fold(uint16_t residual) {
  return Wrapped((residual << 1) ^ ((residual & 0x8000) != 0 ? 0xffff : 0));
}
uint16_t Unfold(uint16_t folded) {
  return Wrapped((folded >> 1) ^ ((folded & 1) != 0 ? 0xffff : 0));
}

/// Calls visit(index, prediction) for each pixel in order, with the prediction
/// from its neighbours; visit() may write the count at index, from which later
/// pixels are predicted.
template <class Visit>
void ForEachPrediction(int width, int height,
                       const std::vector<uint16_t>& counts,
                       const Visit& visit) {
  size_t index = 0;
  const auto w = static_cast<size_t>(width);
  for (int v = 0; v < height; ++v) {
    int left = 0;
    int upper_left = 0;
    for (int u = 0; u < width; ++u, ++index) {
      const int upper = v == 0 ? 0 : counts[index - w];
      visit(index, left + upper - upper_left);
      left = counts[index];
      upper_left = upper;
    }
  }
}

}  // namespace

std::vector<uint8_t> EncodeDepth(const DepthImage& image) {
  const size_t num = image.counts.size();
  if (!IsPictureSize(image.width, image.height) ||
      num != static_cast<size_t>(image.width) *
                 static_cast<size_t>(image.height)) {
    throw std::invalid_argument(fmt::format("{} depths in {} x {} pixels", num,
                                            image.width, image.height));
  }
  std::vector<uint8_t> planes(2 * num);
  ForEachPrediction(
      image.width, image.height, image.counts, [&](size_t i, int prediction) {
        const uint16_t folded = Fold(Wrapped(image.counts[i] - prediction));
        planes[i] = static_cast<uint8_t>(folded & 0xff);
        planes[num + i] = static_cast<uint8_t>(folded >> 8);
      });
  std::vector<uint8_t> bytes(ZSTD_compressBound(planes.size()));
  const size_t size = ZSTD_compress(bytes.data(), bytes.size(), planes.data(),
                                    planes.size(), kLevel);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  bytes.resize(size);
  return bytes;
}

std::optional<DepthImage> DecodeDepth(std::span<const uint8_t> bytes, int width,
                                      int height) {
  if (!IsPictureSize(width, height)) return std::nullopt;
  const size_t num = static_cast<size_t>(width) * static_cast<size_t>(height);
  std::vector<uint8_t> planes(2 * num);
  const size_t size =
      ZSTD_decompress(planes.data(), planes.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) || size != planes.size()) return std::nullopt;
  DepthImage image{width, height, std::vector<uint16_t>(num)};
  ForEachPrediction(width, height, image.counts, [&](size_t i, int prediction) {
    const uint16_t folded = Wrapped(planes[i] | planes[num + i] << 8);
    image.counts[i] = Wrapped(Unfold(folded) + prediction);
  });
  return image;
}

}  // namespace cell
