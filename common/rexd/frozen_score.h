#pragma once

#include <map>

#include "common/rexd/rexd.h"

namespace cell::rexd {

/// How good learned rules are that are changed no more.
struct FrozenScore {
  /// Of an action of the robot: what the rules expect where the true ones bring
  /// about a change.
  struct Expectation {
    double probability = 0;   ///< of that change, mean over the experiences
    int num_experiences = 0;  ///< of the robot, which it comes from
  };
  int num_states = 0;  ///< reachable, and with a way on to the goal
  int num_valid = 0;   ///< in which the first action planned is a right one
  std::map<int, Expectation> expectations;  ///< by action
};

/// Plans from all states that the true rules lead to. A right action changes
/// the state if it succeeds, and leaves the goal within reach.
FrozenScore ScoreFrozen(const RexdTask& task, const RexD& learner);

}  // namespace cell::rexd
