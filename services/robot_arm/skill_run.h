#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/arms/motion_request.h"
#include "common/result/result.h"
#include "services/robot_arm/arm.h"
#include "services/robot_arm/contact/site_frames.h"
#include "services/robot_arm/motions.h"
#include "services/robot_arm/skill_request.h"
#include "services/robot_arm/skills/skill.h"
#include "services/robot_arm/stage_runner.h"

namespace cell::robot_arm {

/// A skill at work: its context, which dies with it, and the stretches that
/// skills are made of.
class SkillRun {
 public:
  /// [m] that each finger opens at first, beside a seated part.
  static constexpr double kLetGoMargin = 0.008;

  /// `arm` and `skill` must outlive this object. Plans the stages.
  SkillRun(Arm& arm, const Skill& skill, SkillRequest request);
  SkillRun(const SkillRun&) = delete;
  SkillRun& operator=(const SkillRun&) = delete;

  /// `dt` [s] of the arm's time; the result once it has ended.
  std::optional<SkillResult> Step(double dt);
  /// Something has gone wrong: it draws back from what is near, then it has
  /// failed. The result if it ends at once.
  std::optional<SkillResult> Fail(const Failure& failure);
  SkillResult Stop(const std::string& reason) const;

  const SkillRequest& request() const { return request_; }
  StageRunner& stages() { return stages_; }
  const StageRunner& stages() const { return stages_; }
  Arm& arm() { return arm_; }

  // ---- what skills are made of (skill_stretches.cc)

  void Add(const Phase& phase, std::function<StageRunner::Made()> make,
           std::function<void()> then = {});
  /// Grasps are rated by where the part goes next.
  using TargetMaker = std::function<Result<PlaceTarget>()>;
  /// Until the fingers hold the part, in its place.
  void Grasp(const TargetMaker& target = {});
  /// The same, and lifts it.
  void PickUp(const TargetMaker& target = {});
  /// To where it is to be put: a request of kPlace or kSetDown for what is
  /// held.
  void Carry(std::function<Result<MotionRequest>()> place);
  /// Upright on a free place within the area, and goes home.
  void SetDown(const Eigen::AlignedBox2d& area, bool is_for_other_arm);
  void LetGo();
  /// From what a stop has left it at.
  void GoFree();
  void DrawBack();
  void GoHome();

  /// A request from where the arm stands.
  MotionRequest RequestOf(MotionRequest::Kind kind) const;
  Result<PlaceTarget> TargetAtSite() const;
  SiteFrames FramesAtSite() const;
  /// The part is held at X_SO, turned so about the site's axis.
  void SetTarget(const PlaceTarget& target, const Eigen::Isometry3d& X_WO) {
    target_ = target;
    X_WO_place_ = X_WO;
  }
  double* peak_force() { return &peak_force_; }

 private:
  using Made = StageRunner::Made;
  using Until = MoveFingers::Until;

  void Plan();
  SkillResult End(SkillResult::Outcome outcome,
                  const std::string& reason) const;
  void WaitForHands(std::function<Eigen::Vector3d()> point,
                    std::function<void()> then = {});
  Made Ask(const MotionRequest& request,
           std::function<void(const MotionPlan&)> use);
  Made Transit(const Joints& q);
  Made Line(const Eigen::Isometry3d& X_WG);
  Made LineBy(const Eigen::Vector3d& way_W);
  Made Fingers(double opening, Until until);

  Arm& arm_;
  const Skill& skill_;
  SkillRequest request_;
  StageRunner stages_;
  GraspChoice grasp_;  // of the part that is taken ...
  Eigen::Isometry3d X_WO_grasp_ = Eigen::Isometry3d::Identity();  // ... there
  PlaceTarget target_;  // of the part that is put down ...
  Eigen::Isometry3d X_WO_place_ = Eigen::Isometry3d::Identity();  // ... there
  Joints q_place_ = Joints::Zero();  // its approach
  double peak_force_ = 0;            // [N]
  std::optional<Failure> failure_;   // that the arm recovers from
};

}  // namespace cell::robot_arm
