#pragma once

#include <string>
#include <vector>

#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// Why the learner has no plan, told to the teacher (section VI-B1). Literals
/// are ground: they are what would have to hold.
struct Guidance {
  /// An action that the goal rests on, and what keeps it from being done.
  struct BlockedAct {
    rules::GroundAct act;
    rules::Literal needs;
  };
  /// The smallest changes of the state after each of which there is a way to
  /// the goal, the best first, see planning::FindExcuses().
  std::vector<std::vector<rules::Literal>> excuses;
  /// Those of them that ask for more of the goal than the first. They are told,
  /// but no reasons are looked for behind them.
  std::vector<std::vector<rules::Literal>> further_excuses;
  std::vector<rules::Literal> missing_effects;
  std::vector<BlockedAct> blocked_acts;  ///< possible wrong preconditions
  /// What can be done meanwhile, each by itself.
  std::vector<rules::Literal> subgoals;

  bool empty() const { return missing_effects.empty() && blocked_acts.empty(); }
};

/// From the smallest excuses of the state; if these ask for literals of the
/// goal, also from those outside the goal of at most two changes, which point
/// at preconditions. Empty if there is a way to the goal, or if no excuse was
/// found within the limits.
/// @param acts  the actions that are known
Guidance FindGuidance(const rules::NdrRules& rules, const RexdTask& task,
                      const rules::WorldState& state,
                      const std::vector<rules::GroundAct>& acts);

/// A sentence for each reason: "I know no action after which
/// swingPlaced(swing).", and for each further excuse.
std::string ToText(const Guidance& guidance, const rules::World& world);

}  // namespace cell::rexd
