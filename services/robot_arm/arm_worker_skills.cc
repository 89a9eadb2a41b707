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
            [this, point] { return !monitor_.IsHandNear(point()); }, kPatience,
            kPersonInTheWay);
      },
      std::move(then));
}

void ArmWorker::PlanInsert() {
  const Site& site = *params_.parts.FindSite(request_->site);
  const Thread* thread = params_.parts.FindThread(site.type);
  if (thread != nullptr && !held_ &&
      FindHoldingSite(request_->part, params_.parts, monitor_.poses()) ==
          &site) {
    return PlanTurnOn(*thread);
  }
  if (!held_) PlanTake(Next::kToSite);
  PlanCarry([this] { return PlaceAtSiteRequest(); });
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
  PlanGrasp(Next::kToSite);
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
  if (!held_) PlanTake(Next::kUnknown);
  PlanSetDown(params_.layout.FindArm(params_.arm)->exchange, true);
}

void ArmWorker::PlanPutDown() {
  if (!held_) return PlanGoHome();
  const CellLayout::PartsArea& area = params_.layout.parts_area;
  PlanSetDown({area.centre - area.size / 2, area.centre + area.size / 2},
              false);
}

void ArmWorker::PlanSetDown(const Eigen::AlignedBox2d& area,
                            bool is_for_other_arm) {
  PlanCarry([this, area, is_for_other_arm]() -> OrReason<MotionRequest> {
    MotionRequest request = Request(MotionRequest::Kind::kSetDown);
    request.area = area;
    request.is_for_other_arm = is_for_other_arm;
    return request;
  });
  Add("set down", [this]() -> Todo::Made {
    is_near_ = true;
    return Line(place_.X_WO * held_->X_GO.inverse());
  });
  PlanLetGo();
  PlanGoHome();
}

/// Until the fingers hold the part, where it stands.
void ArmWorker::PlanGrasp(Next next) {
  Add("plan the grasp", [this, next]() -> Todo::Made {
    monitor_.SetHeld(std::nullopt);
    X_WO_grasp_ = monitor_.poses().at(request_->part);
    return Ask(GraspRequest(next),
               [this](const MotionPlan& plan) { grasp_ = plan.grasp; });
  });
  AddWaitForHands(
      [this] { return monitor_.poses().at(request_->part).translation(); });
  Add("open", [this] { return Fingers(grasp_.opening, Until::kThere); });
  Add("go to " + request_->part, [this] { return Transit(grasp_.q_approach); });
  AddWaitForHands(
      [this] { return monitor_.poses().at(request_->part).translation(); },
      [this] {
        // Where a person has put it now it wants another grasp.
        if (HasMoved(X_WO_grasp_, monitor_.poses().at(request_->part)))
          PlanSkill();
      });
  Add("reach", [this] {
    is_near_ = true;
    return Line(monitor_.poses().at(request_->part) * grasp_.X_OG);
  });
  Add(
      "close",
      [this]() -> Todo::Made {
        if (monitor_.IsHandNear(
                monitor_.poses().at(request_->part).translation())) {
          return kPersonInTheWay;
        }
        return Fingers(grasp_.width - params_.settings.fingers.close_beyond,
                       Until::kGripping);
      },
      [this] {
        const Isometry3d X_WG = kinematics_.GripperPose(reading_.q);
        Hold(request_->part,
             X_WG.inverse() * monitor_.poses().at(request_->part));
      });
}

void ArmWorker::PlanTake(Next next) {
  PlanGrasp(next);
  Add(
      "lift",
      [this] {
        return LineBy(params_.settings.motion.raise * Vector3d::UnitZ());
      },
      [this] { is_near_ = false; });
}

void ArmWorker::PlanCarry(const RequestMaker& place) {
  Add("plan the way", [this, place]() -> Todo::Made {
    monitor_.SetHeld(held_);
    return Ask(place(), [this](const MotionPlan& plan) {
      target_ = plan.target;
      place_.X_WO = plan.X_WO;
      place_.q_approach = plan.waypoints.back();
    });
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
      monitor_.FindGrasped({reading_.q, reading_.stance, reading_.opening});
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

MotionRequest ArmWorker::Request(MotionRequest::Kind kind) const {
  ArmPosture posture{command_->q, command_->grip, command_->opening};
  if (held_) posture = {command_->q, held_->grip, held_->width};
  return monitor_.MakeRequest(kind, posture);
}

OrReason<MotionRequest> ArmWorker::GraspRequest(Next next) const {
  MotionRequest request = Request(MotionRequest::Kind::kGrasp);
  request.part = request_->part;
  if (next == Next::kToSite) {
    auto target = TargetAtSite();
    if (auto* reason = std::get_if<std::string>(&target)) return *reason;
    request.target = std::get<PlaceTarget>(target);
  }
  return request;
}

OrReason<MotionRequest> ArmWorker::PlaceAtSiteRequest() const {
  MotionRequest request = Request(MotionRequest::Kind::kPlace);
  auto target = TargetAtSite();
  if (auto* reason = std::get_if<std::string>(&target)) return *reason;
  request.target = std::get<PlaceTarget>(target);
  return request;
}

ArmWorker::Todo::Made ArmWorker::Ask(
    const OrReason<MotionRequest>& request,
    std::function<void(const MotionPlan&)> use) {
  if (auto* reason = std::get_if<std::string>(&request)) return *reason;
  return std::make_unique<AwaitPlan>(client_, std::get<MotionRequest>(request),
                                     std::move(use));
}

ArmWorker::Todo::Made ArmWorker::Transit(const Joints& q) {
  MotionRequest request =
      monitor_.MakeRequest(MotionRequest::Kind::kWay,
                           {command_->q, command_->grip, command_->opening});
  request.goal = q;
  const MotionSettings& motion = params_.settings.motion;
  const ArmLayout& arm = *params_.layout.FindArm(params_.arm);
  return std::make_unique<FollowWay>(
      client_, request,
      JointRates{
          std::min(motion.transit_speed, arm.model->limits().speed.minCoeff()),
          motion.transit_acceleration});
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
  const auto host = monitor_.poses().find(site.host);
  if (host == monitor_.poses().end())
    return "nobody knows where " + site.host + " is";
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
