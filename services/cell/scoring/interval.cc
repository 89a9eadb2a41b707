#include "services/cell/scoring/interval.h"

#include <algorithm>
#include <cmath>

namespace cell::cli {

Interval WilsonInterval(int num_good, int num_all) {
  if (num_all <= 0) return {};
  constexpr double kZ = 1.959963984540054;
  const double n = num_all;
  const double p = num_good / n;
  const double centre = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double half = kZ / (1 + kZ * kZ / n) *
                      std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace cell::cli
