#include "services/cell/explaining/explainer.h"

#include <algorithm>
#include <cstdlib>

namespace cell::cli {

std::optional<Explanation> NearestTo(
    int64_t utime, const std::vector<Explanation>& explanations) {
  const auto nearest = std::ranges::min_element(
      explanations, {}, [utime](const Explanation& explanation) {
        return std::llabs(explanation.utime - utime);
      });
  if (nearest == explanations.end()) return std::nullopt;
  return *nearest;
}

}  // namespace cell::cli
