#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/relational/rule_set.h"
#include "common/relational/state.h"

namespace cell::cli {

/// The states, and all that actions of the rule set's agent lead to from them,
/// whatever their outcome; in the order in which they are found.
/// @param max_states  at most so many
std::vector<State> StatesFrom(std::span<const State> starts,
                              const RuleSet& rules, Agent agent,
                              size_t max_states);

/// What two sets of rules say differently of one action.
struct ActionComparison {
  int64_t num_both = 0;            ///< states and objects: possible by both
  int64_t num_same = 0;            ///< of these: with the same success
  int64_t num_reference_only = 0;  ///< possible by the reference only
  int64_t num_learned_only = 0;    ///< possible by the learned rules only
  /// The differences in plain words, with how often they occur:
  /// "learned: needs Clear(X)", "success lacks Free(hole)".
  std::map<std::string, int64_t> differences;
};

/// Compares learned rules with reference rules of the same actions, state by
/// state: is the action possible, and what is the state after its success (the
/// likeliest outcome)? What is at fault is named by the literals that a rule
/// needs; of several rules that do not apply, by the one that lacks fewest.
class RuleComparison {
 public:
  /// @pre both have the same vocabulary and actions.
  RuleComparison(std::shared_ptr<const RuleSet> reference,
                 std::shared_ptr<const RuleSet> learned, Agent agent);

  void Add(const State& state);
  /// By the names of actions.
  const std::map<std::string, ActionComparison>& actions() const {
    return actions_;
  }

 private:
  void Add(const GroundAction& action, const State& state);

  std::shared_ptr<const RuleSet> reference_;
  std::shared_ptr<const RuleSet> learned_;
  Agent agent_;
  std::vector<GroundAction> ground_actions_;
  std::map<std::string, ActionComparison> actions_;
};

}  // namespace cell::cli
