#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "common/rules/rule.h"

namespace cell::rules {

/// A literal as the learner keeps it: apart from any rule, so that what is
/// known of it holds for every rule that it is part of. Terms are numbers: the
/// arguments of the action, then, from the number of arguments on, references
/// (FeatureTable::Reference()), or one of the negative codes.
struct Feature {
  static constexpr int32_t kAny = -1;   ///< `_`
  static constexpr int32_t kSelf = -2;  ///< the reference that it defines
  static constexpr int32_t kNone = -3;  ///< unused
  static constexpr int32_t ObjectCode(int object) { return -4 - object; }
  static constexpr int ObjectOf(int32_t code) { return -4 - code; }

  int32_t symbol = 0;
  Comparison comparison = Comparison::kTrue;
  int32_t value = 0;
  std::array<int32_t, kMaxArity> terms = {kNone, kNone, kNone};
  auto operator<=>(const Feature&) const = default;

  bool Names(int32_t term) const {
    return terms[0] == term || terms[1] == term || terms[2] == term;
  }
  Feature Negated() const {
    Feature other = *this;
    other.comparison = Opposite(comparison, &other.value);
    return other;
  }
  /// With `to` in place of the term `from`.
  Feature With(int32_t from, int32_t to) const {
    Feature other = *this;
    for (int32_t& term : other.terms) {
      if (term == from) term = to;
    }
    return other;
  }
};

}  // namespace cell::rules
