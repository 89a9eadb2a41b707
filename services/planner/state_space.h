#pragma once

#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "common/relational/bound_rule.h"
#include "common/relational/rule_set.h"

namespace cell::planner {

/// All states that can be reached from the states entered so far by the
/// actions of one agent; closed under them. States are indices in the order of
/// their discovery.
class StateSpace {
 public:
  struct Move {
    int state;  ///< another one
    double probability;
  };
  /// An action that may change the state; the rest of the probability stays.
  struct Candidate {
    int action;  ///< index among actions()
    double stay;
    std::vector<Move> moves;  ///< each state once
  };

  /// The `blocked` actions are left out.
  StateSpace(std::shared_ptr<const RuleSet> rules, Agent agent,
             const std::set<GroundAction>& blocked = {});

  /// Adds the state and all that can be reached from it. Returns its index;
  /// nothing if there would be more than `max_states`: then the space is empty
  /// again. An unknown atom stays unknown and allows whatever it may (MayHold),
  /// so that more is reachable than truly is.
  std::optional<int> Enter(const State& state, int max_states);

  int size() const { return static_cast<int>(states_.size()); }
  const State& state(int index) const { return states_.at(index); }
  const std::vector<Candidate>& candidates(int state) const {
    return candidates_[state];
  }
  const std::vector<GroundAction>& actions() const { return actions_; }
  const RuleSet& rules() const { return *rules_; }
  Agent agent() const { return agent_; }

  /// Ascending, the state itself among them.
  std::vector<int> ReachableFrom(int state) const;

 private:
  struct HashOfState {
    size_t operator()(const State& state) const { return state.Hash(); }
  };

  int IndexOf(const State& state);
  std::vector<Candidate> CandidatesIn(int state);
  Candidate Try(int action, const BoundRule& rule, int state);

  std::shared_ptr<const RuleSet> rules_;
  Agent agent_;
  std::vector<GroundAction> actions_;
  std::vector<std::vector<BoundRule>> bound_rules_;  // of each action
  std::vector<State> states_;
  std::vector<std::vector<Candidate>> candidates_;
  std::unordered_map<State, int, HashOfState> index_of_;  // never iterated
};

}  // namespace cell::planner
