#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/robot_arm/arm.h"
#include "services/robot_arm/reachable_parts.h"
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/yield_policy.h"

namespace cell::robot_arm {

/// One arm at work: does one skill at a time (section VIII-A), and yields to
/// people and to arms that go first. Pure: outputs are a function of the
/// inputs.
class ArmWorker {
 public:
  using Params = Arm::Params;
  /// What the supervisor allows.
  enum class MotionPermission {
    kMove,    ///< go on
    kFinish,  ///< finish the skill that runs, begin none
    kFreeze   ///< stand still at once
  };

  explicit ArmWorker(const Params& params);
  ArmWorker(const ArmWorker&) = delete;
  ArmWorker& operator=(const ArmWorker&) = delete;

  /// Where parts are tracked; others are unknown. [X_WO]
  void UpdateParts(const std::map<std::string, Eigen::Isometry3d>& poses);
  /// Points on persons' hands [in W].
  void UpdateHands(std::vector<Eigen::Vector3d> points);
  void UpdateOther(const std::string& arm, const ArmPosture& posture,
                   bool is_gripping);
  /// What it asks of the planner of motions since the last call.
  std::vector<MotionRequest> TakeRequests() {
    return arm_.client().TakeRequests();
  }
  /// An answer; false if it does not wait for it.
  bool Put(const MotionPlan& plan) { return arm_.client().Put(plan); }

  /// Takes the skill, or refuses it: then there is a result at once.
  void Begin(const SkillRequest& request, MotionPermission permission);
  /// One tick of `dt` [s]: returns the arm's next command.
  ArmCommand Step(const ArmReading& reading, MotionPermission permission,
                  double dt);
  /// Of a skill that has ended or was refused since the last call.
  std::optional<SkillResult> TakeResult();

  /// Id of the skill that runs; -1: none.
  int64_t request() const { return run_ ? run_->request().id : -1; }
  /// Of the skill that runs.
  Phase phase() const { return run_ ? run_->stages().phase() : Phase{}; }
  /// Part in the gripper; empty: none, or it is not known which. What is left
  /// in an idle gripper though a site holds it counts as placed: before the arm
  /// does anything else it lets go of it.
  std::string held() const;
  bool is_frozen() const { return is_frozen_; }
  /// Parts that it could take where they lie, sorted.
  std::vector<std::string> Reachable() const { return reachable_.List(); }

 private:
  std::optional<std::string> WhyNot(const SkillRequest& request) const;
  bool MustYield(double dt);
  bool ShouldStop(YieldPolicy::Advice advice, const Failure& failure);
  void UpdateHeldPart();
  void End(const std::optional<SkillResult>& result);

  Arm arm_;
  ReachableParts reachable_;
  std::unique_ptr<SkillRun> run_;
  std::optional<SkillResult> result_;
  YieldPolicy to_arms_, to_people_;
  bool is_frozen_ = false;
  double rate_ = 1;  // of time, as the arm starts again
};

}  // namespace cell::robot_arm
