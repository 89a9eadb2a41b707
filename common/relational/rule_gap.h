#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/relational/rule_set.h"

namespace cell {

/// What keeps a rule from covering an action in a state.
struct RuleGap {
  int rule = 0;     ///< of the action
  Binding binding;  ///< as far as its references are unique
  /// Place of the first reference that does not stand for exactly one object.
  std::optional<size_t> reference;
  /// Of the context, those that cannot hold and whose variables are bound.
  std::vector<Literal> literals;

  bool is_covered() const { return !reference && literals.empty(); }
};

/// Of each rule that the action has for the agent, in their order.
std::vector<RuleGap> GapsOf(const RuleSet& rules, const GroundAction& action,
                            const State& state, Agent agent);

/// What would have to hold: "not On(a, _)", "exactly one Z with On(a, Z)".
std::vector<std::string> ShowGap(const RuleSet& rules,
                                 const GroundAction& action,
                                 const RuleGap& gap);

}  // namespace cell
