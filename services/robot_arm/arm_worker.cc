#include "services/robot_arm/arm_worker.h"

#include <algorithm>
#include <utility>

#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kStartTime = 0.3;    // [s] until full speed after a freeze
constexpr double kCarefulRate = 0.5;  // of the speed
const std::vector<double> kLookAhead = {0.05, 0.15, 0.3, 0.45};  // [s]

bool GoesFirst(const CellLayout& layout, const std::string& arm) {
  return std::ranges::min(layout.arms, {}, &ArmLayout::precedence).name == arm;
}

}  // namespace

ArmWorker::ArmWorker(const Params& params)
    : arm_(params),
      reachable_(arm_.parts(), arm_.monitor(), arm_.client()),
      to_arms_(GoesFirst(params.layout, params.arm)),
      to_people_(true) {}

void ArmWorker::UpdateParts(const std::map<std::string, Isometry3d>& poses) {
  arm_.monitor().SetParts(poses);
  reachable_.Update(poses);
}

void ArmWorker::UpdateOther(const std::string& arm, const ArmPosture& posture,
                            bool is_gripping) {
  arm_.monitor().SetOther(arm, posture, is_gripping);
}

void ArmWorker::UpdateHands(std::vector<Vector3d> points) {
  arm_.monitor().SetHands(std::move(points));
}

void ArmWorker::Begin(const SkillRequest& request,
                      MotionPermission permission) {
  const auto refuse = [&](const std::string& reason) {
    result_ = SkillResult{request.id, SkillResult::Outcome::kRefused, reason};
  };
  if (run_) return refuse("it is busy: " + phase().name);
  if (permission != MotionPermission::kMove) return refuse("the cell holds");
  if (!arm_.is_known()) return refuse("the arm's device is silent");
  if (const auto problem = WhyNot(request)) return refuse(*problem);
  // An earlier incarnation or a stop may have left the arm near something: the
  // poses of the parts are known by now.
  if (!arm_.is_near) {
    arm_.is_near = arm_.monitor().IsNearSomething(arm_.command().q);
  }
  run_ = std::make_unique<SkillRun>(arm_, *FindSkill(request.skill), request);
}

std::optional<std::string> ArmWorker::WhyNot(
    const SkillRequest& request) const {
  if (auto why = WhyNoSkill(request, arm_.has_force_sensor())) return why;
  const auto& held = arm_.held();
  if (!held && arm_.reading().is_gripping) {
    return "what it holds is unknown";
  }
  // A site may hold it as well.
  if (held && !arm_.poses().contains(held->part)) {
    return "the pose of " + held->part + " is unknown";
  }
  return FindSkill(request.skill)->WhyNot(request, arm_);
}

ArmCommand ArmWorker::Step(const ArmReading& reading,
                           MotionPermission permission, double dt) {
  arm_.Update(reading, dt);
  UpdateHeldPart();
  reachable_.Step(dt);
  if (reading.is_stopped) {
    if (run_) {
      End(run_->Stop("protective stop: " + reading.why_stopped));
      // Nothing is assumed to be unchanged: everything is determined again.
      arm_.ForgetHeld();
      arm_.is_near.reset();
    }
    arm_.command().q = reading.q;
  }
  is_frozen_ = permission == MotionPermission::kFreeze || reading.is_stopped;
  const bool stands = is_frozen_ || MustYield(dt);
  rate_ = stands ? 0 : std::min(1.0, rate_ + dt / kStartTime);
  const double careful = run_ && run_->request().is_careful ? kCarefulRate : 1;
  if (run_ && !stands) End(run_->Step(careful * rate_ * dt));
  return arm_.command();
}

/// True if it would come too near to people, or else to an arm with precedence.
bool ArmWorker::MustYield(double dt) {
  const ArmCommand& command = arm_.command();
  const ArmPosture now{command.q, command.grip, command.opening};
  const bool is_moving = run_ && run_->stages().is_running();
  SceneMonitor::WayAhead way;
  if (is_moving) {
    way = run_->stages().Ahead(kLookAhead, command.q);
    run_->stages().TryOtherWay(dt);
  }
  const bool is_person_there =
      is_moving && arm_.monitor().WouldCollideWithPerson(now, way);
  if (ShouldStop(to_people_.Step(is_person_there, dt),
                 Failure::PersonInTheWay())) {
    return true;
  }
  const bool is_other_there = run_ && run_->stages().is_running() &&
                              arm_.monitor().WouldCollideWithArm(now, way);
  return ShouldStop(to_arms_.Step(is_other_there, dt),
                    {"another arm is in the way"});
}

/// True if it stops in this tick.
bool ArmWorker::ShouldStop(YieldPolicy::Advice advice, const Failure& failure) {
  if (run_ && advice == YieldPolicy::Advice::kGoAround) {
    run_->stages().SeekOtherWay();
  }
  if (run_ && advice == YieldPolicy::Advice::kGiveUp) End(run_->Fail(failure));
  return advice != YieldPolicy::Advice::kGo;
}

void ArmWorker::End(const std::optional<SkillResult>& result) {
  if (!result) return;
  result_ = result;
  run_.reset();
}

std::optional<SkillResult> ArmWorker::TakeResult() {
  return std::exchange(result_, std::nullopt);
}

std::string ArmWorker::held() const {
  const bool is_placed = !run_ && arm_.SiteOfHeld() != nullptr;
  return arm_.held() && !is_placed ? arm_.held()->part : "";
}

/// Handles fingers that have lost what they held, or that held something before
/// this process started.
void ArmWorker::UpdateHeldPart() {
  if (arm_.reading().is_gripping) {
    if (!arm_.held() && !run_) arm_.RecogniseHeld();
    return;
  }
  if (!arm_.held() || arm_.is_releasing) return;
  const std::string lost = "it has lost " + arm_.held()->part;
  arm_.ForgetHeld();
  if (run_) End(run_->Fail({lost}));
}

}  // namespace cell::robot_arm
