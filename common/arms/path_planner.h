#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/layout/arm_layout.h"
#include "common/result/result.h"

namespace cell {

/// Why an arm may not be in this posture; nothing if it may.
using WhyBlockedAt = std::function<std::optional<std::string>(const Joints&)>;

struct PathPlannerParams {
  /// With the levers and limits of a kind of arm.
  explicit PathPlannerParams(const ArmModel& model);

  /// [m] by which the fingertips move, at most and about, between two checks:
  /// less than twice the clearance that the checks want, and nothing is missed.
  double tip_step = 0.015;
  /// [m] Of the fingertips about each axis.
  Joints levers;
  /// [rad] Of each joint in either direction.
  Joints max_angle;
  double tree_step = 0.35;    ///< [rad] by which a tree grows
  int max_iterations = 2000;  ///< of the trees
  int shortcut_rounds = 60;
  double joint_margin = 0.05;  ///< [rad] kept from the limits
  uint64_t seed = 1;
};

/// A way through joint space, from start to goal, or why there is none.
using JointPath = Result<std::vector<Joints>>;

/// Nothing if the straight line from `a` to `b` is free, else what is first in
/// its way. `a` itself is not looked at.
std::optional<std::string> WhyEdgeBlocked(const Joints& a, const Joints& b,
                                          const WhyBlockedAt& why_blocked,
                                          const PathPlannerParams& params);

/// Asks the scene, as it is now, about an arm with its hand as in `posture`.
WhyBlockedAt AskScene(const ArmScene& scene, const std::string& arm,
                      const ArmPosture& posture, const ClearanceRule& rule);

/// A free path from `start` to the first of the goals, best first, that has
/// one: straight; through one of `vias`, e.g. a raised posture; or, to any
/// goal, by two trees that grow towards each other (RRT-Connect, Kuffner and
/// LaValle 2000), smoothed by shortcuts. A function of its arguments: chance is
/// drawn from the seed.
JointPath PlanPath(const Joints& start, const std::vector<Joints>& goals,
                   const std::vector<Joints>& vias,
                   const WhyBlockedAt& why_blocked,
                   const PathPlannerParams& params);

}  // namespace cell
