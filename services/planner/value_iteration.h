#pragma once

#include <vector>

#include "services/planner/state_space.h"

namespace cell::planner {

/// For every state of a space the highest probability P of reaching a goal
/// and, among the ways that have it, the least expected number of actions C
/// given that the goal is reached (S3P: Teichteil-Koenigsbuch, AAAI 2012).
///
/// Both come from value iteration from below: P from 0 cannot be trapped by
/// end components, which would hold up an iteration from above (Haddad and
/// Monmege, TCS 2018), and C from 0 climbs to the least fixed point, since
/// every action costs 1.
class ValueIteration {
 public:
  /// Of a candidate: as of a state when this action is done first.
  struct Value {
    double probability = 0;
    double expected_actions = 0;  ///< 0 if the probability is
  };

  /// Values of the states that the space has gained since the last call.
  /// `is_goal`: of every state.
  void Extend(const StateSpace& space, const std::vector<bool>& is_goal);
  void Clear() { values_.clear(); }

  const Value& Of(int state) const { return values_.at(state); }
  Value Of(const StateSpace::Candidate& candidate, int state) const;
  /// Position among the state's candidates of the best one, the first of
  /// equals; -1 if the goal cannot be reached or is reached.
  int Best(const StateSpace& space, int state) const;

 private:
  double ProbabilityOf(const StateSpace::Candidate& candidate) const;
  double ActionsOf(const StateSpace::Candidate& candidate, int state) const;

  std::vector<Value> values_;
};

}  // namespace cell::planner
