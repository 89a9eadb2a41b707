#pragma once

#include <cstdint>

namespace cell::rules {

struct LearnerOptions {
  /// Weight of the complexity penalty in eq. (1).
  double alpha = 0.5;
  /// Probability of a change that a rule explains by its noise outcome only,
  /// given that outcome.
  double p_min = 1e-10;
  /// The same of the default rule.
  double p_min_default = 1e-11;
  /// Whether literals may say `_`: some object, or none.
  bool is_quantified = true;
  /// Orders the examples that new rules are made for.
  uint64_t seed = 1;
};

}  // namespace cell::rules
