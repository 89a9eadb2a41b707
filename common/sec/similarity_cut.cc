#include "common/sec/similarity_cut.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cell {
namespace {

constexpr size_t kNumBins = 50;

size_t BinOf(double similarity) {
  const double bin = std::clamp(similarity, 0.0, 1.0) * kNumBins;
  return std::min(static_cast<size_t>(bin), kNumBins - 1);
}

}  // namespace

double OtsuCut(std::span<const double> similarities) {
  std::array<double, kNumBins> histogram{};
  for (const double similarity : similarities) ++histogram[BinOf(similarity)];
  double all = 0, sum = 0;
  for (size_t bin = 0; bin < kNumBins; ++bin) {
    all += histogram[bin];
    sum += histogram[bin] * static_cast<double>(bin);
  }
  double low = 0, sum_low = 0, best = 0;
  size_t first = 0, last = 0;
  for (size_t border = 1; border < kNumBins; ++border) {
    low += histogram[border - 1];
    sum_low += histogram[border - 1] * static_cast<double>(border - 1);
    const double high = all - low;
    if (low == 0 || high == 0) continue;
    const double apart = sum_low / low - (sum - sum_low) / high;
    const double variance = low * high * apart * apart;
    if (variance > best) first = border;
    if (variance >= best) last = border;
    best = std::max(best, variance);
  }
  return static_cast<double>(first + last) / (2 * kNumBins);
}

double MeanFrom(double cut, std::span<const double> similarities) {
  double sum = 0;
  int num_high = 0;
  for (const double similarity : similarities) {
    if (similarity < cut) continue;
    sum += similarity;
    ++num_high;
  }
  return num_high == 0 ? cut : sum / num_high;
}

}  // namespace cell
