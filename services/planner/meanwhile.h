#pragma once

#include <optional>
#include <set>

#include "services/planner/current_plan.h"

namespace cell::planner {

/// What the robot can do although no plan leads from `state` to the goal
/// (section VI-B1): the first step of the plan that there would be if all that
/// is needed were so and nothing had failed, that is possible as things are.
/// It leaves the goal as likely once a person has helped. Nullopt: all that
/// does not depend on the person is done.
/// @param plan     none was found for `state`
/// @param blocked  actions that are not to be done
std::optional<GroundAction> StepMeanwhile(
    const CurrentPlan& plan, const State& state,
    const std::set<GroundAction>& blocked);

}  // namespace cell::planner
