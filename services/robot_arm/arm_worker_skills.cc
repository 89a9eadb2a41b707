// Each skill as the stages that it is made of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/robot_arm/arm_worker.h"
#include "services/robot_arm/contact/contact_stage.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "services/robot_arm/fastening.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kPatience = 15;  // [s] with people's hands

}  // namespace

void ArmWorker::Add(const std::string& phase, std::function<Todo::Made()> make,
                    std::function<void()> then) {
  todos_.push_back({phase, std::move(make), std::move(then)});
}

/// People come first: it waits until their hands are away from the point.
void ArmWorker::AddWaitForHands(std::function<Vector3d()> point,
                                std::function<void()> then) {
  Add(
      "wait for the person",
      [this, point]() -> Todo::Made {
        return std::make_unique<WaitUntil>(
            [this, point] { return !planner_.IsHandNear(point()); }, kPatience,
            kPersonInTheWay);
      },
      std::move(then));
}

void ArmWorker::PlanInsert() {
  const auto target = [this] {
    return TargetAtSite();
  };
  const Site& site = *params_.parts.FindSite(request_->site);
  const Thread* thread = params_.parts.FindThread(site.type);
  if (thread != nullptr && !held_ &&
      FindHoldingSite(request_->part, params_.parts, poses_) == &site) {
    return PlanTurnOn(*thread);
  }
  if (!held_) PlanTake(target);
  PlanCarry(target);
  Add("tare", [this]() -> Todo::Made {
    is_near_ = true;
    return std::make_unique<Tare>(sensor_);
  });
  Add("seat", [this, type = site.type]() -> Todo::Made {
    return std::make_unique<ContactStage>(
        kinematics_, sensor_, FramesAtSite(),
        InsertionMaker(params_.settings.insertions.at(type)), &peak_force_);
  });
  if (thread != nullptr) {
    Add("turn", [this, pitch = thread->pitch]() -> Todo::Made {
      return std::make_unique<ContactStage>(
          kinematics_, sensor_, FramesAtSite(),
          ScrewingMaker(params_.settings.screwing, pitch), &peak_force_);
    });
  }
  PlanLetGo();
}

/// Of a part that is on its thread, and not home: it is turned on from there.
void ArmWorker::PlanTurnOn(const Thread& thread) {
  // Before anything touches the fingers: the thread carries the part's weight.
  Add("tare", [this] { return std::make_unique<Tare>(sensor_); });
  PlanGrasp([this] { return TargetAtSite(); });
  Add("turn", [this, pitch = thread.pitch]() -> Todo::Made {
    sensor_.Unload();
    auto target = TargetAtSite();
    if (auto* reason = std::get_if<std::string>(&target)) return *reason;
    target_ = std::get<PlaceTarget>(target);
    const Isometry3d X_SO = target_.X_WO.inverse() *
                            kinematics_.GripperPose(command_->q) * held_->X_GO;
    const Eigen::Matrix3d& R = X_SO.linear();
    const double yaw = std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
    place_.X_WO = target_.X_WO * Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
    const ScrewingParams params =
        params_.settings.screwing.GoingOnAt(X_SO.translation().z(), pitch);
    return std::make_unique<ContactStage>(kinematics_, sensor_, FramesAtSite(),
                                          ScrewingMaker(params, pitch),
                                          &peak_force_);
  });
  PlanLetGo();
}

/// Where the other arm can take it.
void ArmWorker::PlanPresent() {
  if (!held_) PlanTake({});
  PlanSetDown(params_.layout.FindArm(params_.arm)->exchange,
              ArmPlanner::Taker::kOtherArm);
}

void ArmWorker::PlanPutDown() {
  if (!held_) return PlanGoHome();
  const CellLayout::PartsArea& area = params_.layout.parts_area;
  PlanSetDown({area.centre - area.size / 2, area.centre + area.size / 2},
              ArmPlanner::Taker::kAnyone);
}

void ArmWorker::PlanSetDown(const Eigen::AlignedBox2d& area,
                            ArmPlanner::Taker taker) {
  PlanCarry([this, area, taker] {
    return planner_.FindFreePlace(area, taker, command_->q);
  });
  Add("set down", [this]() -> Todo::Made {
    is_near_ = true;
    return Line(place_.X_WO * held_->X_GO.inverse());
  });
  PlanLetGo();
  PlanGoHome();
}

/// Until the fingers hold the part, where it stands.
void ArmWorker::PlanGrasp(const TargetMaker& target) {
  Add("plan the grasp", [this, target]() -> Todo::Made {
    std::optional<PlaceTarget> wanted;
    if (target) {
      auto made = target();
      if (auto* reason = std::get_if<std::string>(&made)) return *reason;
      wanted = std::get<PlaceTarget>(made);
    }
    planner_.SetHeld(std::nullopt);
    auto planned = planner_.PlanPick(request_->part, wanted, command_->q);
    if (auto* reason = std::get_if<std::string>(&planned)) return *reason;
    grasp_ = std::get<GraspChoice>(planned);
    X_WO_grasp_ = poses_.at(request_->part);
    return std::unique_ptr<SkillStage>();
  });
  AddWaitForHands([this] { return poses_.at(request_->part).translation(); });
  Add("open", [this] { return Fingers(grasp_.opening, Until::kThere); });
  Add("go to " + request_->part, [this] { return Transit(grasp_.q_approach); });
  AddWaitForHands([this] { return poses_.at(request_->part).translation(); },
                  [this] {
                    // Where a person has put it now it wants another grasp.
                    if (HasMoved(X_WO_grasp_, poses_.at(request_->part)))
                      PlanSkill();
                  });
  Add("reach", [this] {
    is_near_ = true;
    return Line(poses_.at(request_->part) * grasp_.X_OG);
  });
  Add(
      "close",
      [this]() -> Todo::Made {
        if (planner_.IsHandNear(poses_.at(request_->part).translation())) {
          return kPersonInTheWay;
        }
        return Fingers(grasp_.width - params_.settings.fingers.close_beyond,
                       Until::kGripping);
      },
      [this] {
        const Isometry3d X_WG = kinematics_.GripperPose(reading_.q);
        Hold(request_->part, X_WG.inverse() * poses_.at(request_->part));
      });
}

void ArmWorker::PlanTake(const TargetMaker& target) {
  PlanGrasp(target);
  Add(
      "lift",
      [this] {
        return LineBy(params_.settings.motion.raise * Vector3d::UnitZ());
      },
      [this] { is_near_ = false; });
}

void ArmWorker::PlanCarry(const TargetMaker& target) {
  Add("plan the way", [this, target]() -> Todo::Made {
    planner_.SetHeld(held_);
    auto made = target();
    if (auto* reason = std::get_if<std::string>(&made)) return *reason;
    target_ = std::get<PlaceTarget>(made);
    auto planned = planner_.PlanPlace(target_, command_->q);
    if (auto* reason = std::get_if<std::string>(&planned)) return *reason;
    place_ = std::get<PlaceChoice>(planned);
    return std::unique_ptr<SkillStage>();
  });
  AddWaitForHands([this] { return target_.X_WO.translation(); });
  Add("carry", [this] { return Transit(place_.q_approach); });
}

void ArmWorker::PlanLetGo() {
  Add(
      kLetGo,
      [this] {
        return Fingers(held_->width + 2 * kLetGoMargin, Until::kReleased);
      },
      [this] { ForgetHeld(); });
  PlanDrawBack();
}

/// From what a stop has left it at: fingers that are around a part, and hold
/// nothing, leave it room.
void ArmWorker::PlanGoFree() {
  const auto part =
      planner_.FindGrasped({reading_.q, reading_.stance, reading_.opening});
  if (part && !held_) {
    double width = 0;
    for (const Grasp& grasp : params_.parts.Find(*part)->grasps) {
      width = std::max(width, grasp.width);
    }
    const double open = width + 2 * kLetGoMargin;
    if (command_->opening < open) {
      Add("open", [=, this] { return Fingers(open, Until::kThere); });
    }
  }
  PlanDrawBack();
}

void ArmWorker::PlanDrawBack() {
  Add(
      "draw back",
      [this] {
        return LineBy(params_.settings.motion.approach *
                      kinematics_.GripperPose(command_->q).linear().col(2));
      },
      [this] { is_near_ = false; });
}

void ArmWorker::PlanGoHome() {
  Add("go home",
      [this] { return Transit(params_.layout.FindArm(params_.arm)->home); });
}

// ---- what the stages are made of

ArmWorker::Todo::Made ArmWorker::Transit(const Joints& q) {
  auto planned =
      planner_.PlanTransit(command_->q, q, command_->opening, command_->grip);
  if (auto* reason = std::get_if<std::string>(&planned)) return *reason;
  return std::make_unique<FollowTrajectory>(
      std::get<JointTrajectory>(std::move(planned)));
}

/// As far that way [m, in W] as the arm can go.
ArmWorker::Todo::Made ArmWorker::LineBy(const Vector3d& way_W) {
  constexpr int kNumSteps = 20;
  Isometry3d X_WG = kinematics_.GripperPose(command_->q);
  Joints q = command_->q;
  for (int i = 0; i < kNumSteps; ++i) {
    const Isometry3d next = Translation3d(way_W / kNumSteps) * X_WG;
    const auto solution = kinematics_.JointsNear(next, q);
    if (!solution) break;
    q = *solution;
    X_WG = next;
  }
  return Line(X_WG);
}

ArmWorker::Todo::Made ArmWorker::Line(const Isometry3d& X_WG) {
  return std::make_unique<MoveOnLine>(kinematics_, X_WG,
                                      params_.settings.motion.line_speed);
}

ArmWorker::Todo::Made ArmWorker::Fingers(double opening, Until until) {
  const std::string& grip = held_ ? held_->grip : grasp_.grip;
  return std::make_unique<MoveFingers>(std::max(opening, 0.0), grip, until);
}

OrReason<PlaceTarget> ArmWorker::TargetAtSite() const {
  const Site& site = *params_.parts.FindSite(request_->site);
  const auto host = poses_.find(site.host);
  if (host == poses_.end()) return "nobody knows where " + site.host + " is";
  PlaceTarget target = TargetAt(site, host->second);
  const Eigen::Vector2d& aim = params_.settings.insertions.at(site.type).aim;
  target.X_WO = target.X_WO * params_.settings.aim_error.Of(request_->id) *
                Translation3d(aim.x(), aim.y(), 0);
  if (params_.parts.FindThread(site.type) != nullptr) {
    target.turn = -params_.settings.screwing.tight.max_angle;
  }
  return target;
}

SiteFrames ArmWorker::FramesAtSite() const {
  return {target_.X_WO, held_->X_GO, target_.X_WO.inverse() * place_.X_WO};
}

}  // namespace cell::robot_arm
