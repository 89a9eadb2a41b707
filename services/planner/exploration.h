#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "common/experiences/task_experience.h"
#include "services/planner/current_plan.h"

namespace cell::planner {

/// How a robot learns by doing (REX-D, section VI-B). What it has learned from
/// is shared.
struct Exploration {
  /// An action is known where its rule was learned from so many experiences.
  int known_count = 2;
  /// An operator has to let an arm do what it has learned for the first time.
  bool needs_confirmation = true;
  std::set<std::string> confirmed = {};  ///< actions
  /// Actions whose rules came with the task: arms do them like any other,
  /// whatever has been learned of them since.
  std::set<std::string> shipped = {};
  std::shared_ptr<const std::vector<TaskExperience>> experiences;
};

/// True of an action that was learned and that no arm has done yet.
bool IsNewToArms(const Action& action,
                 std::span<const TaskExperience> experiences);

/// Of the actions that rules learned from too few experiences expect to change
/// something now, the one that was tried least; nullopt: the state is known.
/// Actions that are `blocked` are left out.
std::optional<GroundAction> LeastTried(const RuleSet& rules, const State& state,
                                       const std::set<GroundAction>& blocked,
                                       int known_count);

/// What the robot does when no plan leads from `state` to the goal, before it
/// asks: a step towards another literal of the goal (section VI-B1: subgoals)
/// that keeps those that hold, or else one by a rule alternative: a rule
/// without the conditions that fail, as long as these name none of its objects
/// and no experiences speak against it. nullopt if there is neither.
std::optional<GroundAction> StepWithoutPlan(
    const CurrentPlan& plan, const State& state,
    const std::set<GroundAction>& blocked, const Exploration& exploration);

}  // namespace cell::planner
