#include "common/sec/similarity_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cell {
namespace {

constexpr size_t kNumBins = 50;
constexpr double kTwoGroups = 0.8;  // explained variance
constexpr double kApart = 0.05;

size_t BinOf(double similarity) {
  const double bin = std::clamp(similarity, 0.0, 1.0) * kNumBins;
  return std::min(static_cast<size_t>(bin), kNumBins - 1);
}

/// Otsu's bound, and the share of the variance that it explains.
struct Bound {
  double cut = 0;
  double explained = 0;
  double apart = 0;  // the means of both sides
};

Bound BoundOf(std::span<const double> similarities) {
  std::array<double, kNumBins> histogram{};
  for (const double similarity : similarities) ++histogram[BinOf(similarity)];
  double all = 0, sum = 0, squares = 0;
  for (size_t bin = 0; bin < kNumBins; ++bin) {
    const auto value = static_cast<double>(bin);
    all += histogram[bin];
    sum += histogram[bin] * value;
    squares += histogram[bin] * value * value;
  }
  Bound bound;
  double low = 0, sum_low = 0, best = 0;
  size_t first = 0, last = 0;
  for (size_t border = 1; border < kNumBins; ++border) {
    low += histogram[border - 1];
    sum_low += histogram[border - 1] * static_cast<double>(border - 1);
    const double high = all - low;
    if (low == 0 || high == 0) continue;
    const double apart = sum_low / low - (sum - sum_low) / high;
    const double variance = low * high * apart * apart;
    if (variance > best) {
      first = border;
      bound.apart = std::abs(apart) / kNumBins;
    }
    if (variance >= best) last = border;
    best = std::max(best, variance);
  }
  // Both are multiplied by the square of their number.
  const double variance = all * squares - sum * sum;
  bound.cut = static_cast<double>(first + last) / (2 * kNumBins);
  if (variance > 0) bound.explained = best / variance;
  return bound;
}

}  // namespace

double OtsuCut(std::span<const double> similarities) {
  return BoundOf(similarities).cut;
}

double HighestCut(std::span<const double> similarities) {
  std::vector<double> high(similarities.begin(), similarities.end());
  double cut = OtsuCut(high);
  while (true) {
    std::erase_if(high, [cut](double similarity) { return similarity < cut; });
    const Bound next = BoundOf(high);
    if (next.explained < kTwoGroups || next.apart < kApart || next.cut <= cut)
      return cut;
    cut = next.cut;
  }
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
