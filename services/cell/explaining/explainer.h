#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "services/cell/explaining/explanation.h"

namespace cell::cli {

/// Explains one kind of thing that a cell did in a recorded run, by computing
/// again what a service has computed. Never from ground truth.
class Explainer {
 public:
  Explainer() = default;
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;
  virtual ~Explainer() = default;

  /// [us] of all that it can explain, in the order of the log.
  virtual std::vector<int64_t> Utimes() const = 0;
  /// All that it can explain of this moment [us].
  virtual std::vector<Explanation> At(int64_t utime) const = 0;
};

/// The one nearest to `utime` [us], of equals the first; nullopt if there is
/// none.
std::optional<int64_t> NearestTo(int64_t utime,
                                 const std::vector<int64_t>& utimes);

}  // namespace cell::cli
