// The stretches that skills are made of.
#include <algorithm>
#include <utility>

#include "services/robot_arm/reachable_parts.h"
#include "services/robot_arm/skill_run.h"

namespace cell::robot_arm {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

void SkillRun::Add(const Phase& phase, std::function<Made()> make,
                   std::function<void()> then) {
  stages_.Add({phase, std::move(make), std::move(then)});
}

/// People come first: it waits until their hands are away from the point.
void SkillRun::WaitForHands(std::function<Vector3d()> point,
                            std::function<void()> then) {
  Add(
      {"wait for the person"},
      [this, point]() -> Made {
        return std::make_unique<WaitForPerson>(
            [this, point] { return arm_.monitor().IsHandNear(point()); },
            arm_.settings().distances.patience);
      },
      std::move(then));
}

void SkillRun::Grasp(const TargetMaker& target) {
  const std::string part = request_.Argument("part");
  const auto place = [this, part] {
    return arm_.poses().at(part).translation();
  };
  Add({"plan the grasp"}, [this, part, target]() -> Made {
    MotionRequest request = RequestOf(MotionRequest::Kind::kGrasp);
    request.part = part;
    if (target) {
      const auto wanted = target();
      if (!wanted) return Reason{wanted.reason()};
      request.target = *wanted;
    }
    X_WO_grasp_ = arm_.poses().at(part);
    return Ask(request,
               [this](const MotionPlan& plan) { grasp_ = plan.grasp; });
  });
  WaitForHands(place);
  Add({"open"}, [this] { return Fingers(grasp_.opening, Until::kThere); });
  Add({"go to " + part}, [this] { return Transit(grasp_.q_approach); });
  WaitForHands(place, [this, part] {
    // A person has moved it: it needs another grasp.
    if (HasMoved(X_WO_grasp_, arm_.poses().at(part))) Plan();
  });
  Add({"reach"}, [this, part] {
    arm_.is_near = true;
    return Line(arm_.poses().at(part) * grasp_.X_OG);
  });
  Add(
      {"close", Contact::kPartsAndTable},
      [this, place]() -> Made {
        if (arm_.monitor().IsHandNear(place())) {
          return std::make_unique<WaitForPerson>([] { return true; }, 0);
        }
        return Fingers(grasp_.width - arm_.settings().fingers.close_beyond,
                       Until::kGripping);
      },
      [this, part] {
        const Isometry3d X_WG = arm_.kinematics().GripperPose(arm_.reading().q);
        arm_.Hold({part, X_WG.inverse() * arm_.poses().at(part), grasp_.grip,
                   grasp_.width});
      });
}

void SkillRun::PickUp(const TargetMaker& target) {
  Grasp(target);
  Add(
      {"lift", Contact::kPartsAndTable},
      [this] {
        return LineBy(arm_.settings().motion.raise * Vector3d::UnitZ());
      },
      [this] { arm_.is_near = false; });
}

void SkillRun::Carry(std::function<Result<MotionRequest>()> place) {
  Add({"plan the way"}, [this, place = std::move(place)]() -> Made {
    arm_.monitor().SetHeld(arm_.held());
    const auto request = place();
    if (!request) return Reason{request.reason()};
    return Ask(*request, [this](const MotionPlan& plan) {
      SetTarget(plan.target, plan.X_WO);
      q_place_ = plan.waypoints.back();
    });
  });
  WaitForHands([this] { return target_.X_WO.translation(); });
  Add({"carry"}, [this] { return Transit(q_place_); });
}

void SkillRun::SetDown(const Eigen::AlignedBox2d& area, bool is_for_other_arm) {
  Carry([this, area, is_for_other_arm]() -> Result<MotionRequest> {
    MotionRequest request = RequestOf(MotionRequest::Kind::kSetDown);
    request.area = area;
    request.is_for_other_arm = is_for_other_arm;
    return request;
  });
  Add({"set down", Contact::kPartsAndTable}, [this] {
    arm_.is_near = true;
    return Line(X_WO_place_ * arm_.held()->X_GO.inverse());
  });
  LetGo();
  GoHome();
}

void SkillRun::LetGo() {
  Add(
      {"let go", Contact::kPartsAndTable},
      [this] {
        arm_.is_releasing = true;
        return Fingers(arm_.held()->width + 2 * kLetGoMargin, Until::kReleased);
      },
      [this] { arm_.ForgetHeld(); });
  DrawBack();
}

/// Fingers that are around a part, and hold nothing, leave it room.
void SkillRun::GoFree() {
  const auto part = arm_.FindGrasped();
  if (part && !arm_.held()) {
    double width = 0;
    for (const cell::Grasp& grasp : arm_.parts().Find(*part)->grasps) {
      width = std::max(width, grasp.width);
    }
    const double open = width + 2 * kLetGoMargin;
    if (arm_.command().opening < open) {
      Add({"open"}, [=, this] { return Fingers(open, Until::kThere); });
    }
  }
  DrawBack();
}

void SkillRun::DrawBack() {
  Add(
      {"draw back", Contact::kPartsAndTable},
      [this] {
        return LineBy(
            arm_.settings().motion.approach *
            arm_.kinematics().GripperPose(arm_.command().q).linear().col(2));
      },
      [this] { arm_.is_near = false; });
}

void SkillRun::GoHome() {
  Add({"go home"}, [this] { return Transit(arm_.layout().home); });
}

// ---- what the stretches are made of

MotionRequest SkillRun::RequestOf(MotionRequest::Kind kind) const {
  const ArmCommand& command = arm_.command();
  ArmPosture posture{command.q, command.grip, command.opening};
  if (arm_.held()) {
    posture.grip = arm_.held()->grip;
    posture.opening = arm_.held()->width;
  }
  return arm_.monitor().MakeRequest(kind, posture);
}

SkillRun::Made SkillRun::Ask(const MotionRequest& request,
                             std::function<void(const MotionPlan&)> use) {
  return std::make_unique<AwaitPlan>(arm_.client(), request, std::move(use));
}

SkillRun::Made SkillRun::Transit(const Joints& q) {
  const ArmCommand& command = arm_.command();
  MotionRequest request = arm_.monitor().MakeRequest(
      MotionRequest::Kind::kWay, {command.q, command.grip, command.opening});
  request.goal = q;
  const MotionSettings& motion = arm_.settings().motion;
  return std::make_unique<FollowWay>(
      arm_.client(), request,
      JointRates{std::min(motion.transit_speed,
                          arm_.layout().model->limits().speed.minCoeff()),
                 motion.transit_acceleration});
}

/// As far that way [m, in W] as the arm can go.
SkillRun::Made SkillRun::LineBy(const Vector3d& way_W) {
  constexpr int kNumSteps = 20;
  Joints q = arm_.command().q;
  Isometry3d X_WG = arm_.kinematics().GripperPose(q);
  for (int i = 0; i < kNumSteps; ++i) {
    const Isometry3d next = Translation3d(way_W / kNumSteps) * X_WG;
    const auto solution = arm_.kinematics().JointsNear(next, q);
    if (!solution) break;
    q = *solution;
    X_WG = next;
  }
  return Line(X_WG);
}

SkillRun::Made SkillRun::Line(const Isometry3d& X_WG) {
  return std::make_unique<MoveOnLine>(arm_.kinematics(), X_WG,
                                      arm_.settings().motion.line_speed);
}

SkillRun::Made SkillRun::Fingers(double opening, Until until) {
  const std::string& planned =
      grasp_.grip.empty() ? arm_.command().grip : grasp_.grip;
  return std::make_unique<MoveFingers>(
      std::max(opening, 0.0), arm_.held() ? arm_.held()->grip : planned, until);
}

Result<PlaceTarget> SkillRun::TargetAtSite() const {
  const Site& site = *arm_.parts().FindSite(request_.Argument("site"));
  const auto host = arm_.poses().find(site.host);
  if (host == arm_.poses().end()) {
    return Reason{"the pose of " + site.host + " is unknown"};
  }
  PlaceTarget target = TargetAt(site, host->second);
  const SkillSettings& settings = arm_.settings();
  const Eigen::Vector2d& aim = settings.insertions.at(site.type).aim;
  target.X_WO = target.X_WO * settings.aim_error.Of(request_.id) *
                Translation3d(aim.x(), aim.y(), 0);
  if (arm_.parts().FindThread(site.type) != nullptr) {
    target.turn = -settings.screwing.tight.max_angle;
  }
  return target;
}

SiteFrames SkillRun::FramesAtSite() const {
  return {target_.X_WO, arm_.held()->X_GO,
          target_.X_WO.inverse() * X_WO_place_};
}

}  // namespace cell::robot_arm
