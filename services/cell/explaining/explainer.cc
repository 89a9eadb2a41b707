#include "services/cell/explaining/explainer.h"

#include <algorithm>
#include <cstdlib>

namespace cell::cli {

std::optional<int64_t> NearestTo(int64_t utime,
                                 const std::vector<int64_t>& utimes) {
  const auto nearest = std::ranges::min_element(
      utimes, {}, [utime](int64_t other) { return std::llabs(other - utime); });
  if (nearest == utimes.end()) return std::nullopt;
  return *nearest;
}

}  // namespace cell::cli
