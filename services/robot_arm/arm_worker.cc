#include "services/robot_arm/arm_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "services/robot_arm/fastening.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kStartTime = 0.3;  // [s] until full speed after a freeze
constexpr double kLookAhead[] = {0.05, 0.15, 0.3, 0.45};  // [s] for other arms
constexpr double kStill = 1e-3;                           // [rad/s]
constexpr double kLookTime = 0.3;  // [s] at rest, before tracks show it there

constexpr char kHolds[] = "the cell holds";

}  // namespace

ArmWorker::ArmWorker(const Params& params)
    : params_(params),
      kinematics_(*params_.layout.FindArm(params_.arm)),
      sensor_(kinematics_, *params_.layout.FindArm(params_.arm),
              params_.settings.force_sensor),
      monitor_({params.arm, params.layout, params.parts,
                params.settings.motion.clearance}),
      reachable_(params_.parts, monitor_, client_),
      // Who inserts goes first.
      way_of_others_(params_.layout.FindArm(params_.arm)->X_FS.has_value()),
      way_of_people_(true) {}

void ArmWorker::See(const std::map<std::string, Isometry3d>& poses) {
  monitor_.SetParts(poses);
  reachable_.Update(poses);
}

void ArmWorker::SeeOther(const std::string& arm, const ArmPosture& posture,
                         bool is_gripping) {
  monitor_.SetOther(arm, posture, is_gripping);
}

void ArmWorker::SeeHands(std::vector<Vector3d> points) {
  monitor_.SetHands(std::move(points));
}

std::vector<std::string> ArmWorker::Reachable() const {
  return reachable_.List();
}

void ArmWorker::Begin(const SkillRequest& request, Leave leave) {
  const auto refuse = [&](const std::string& reason) {
    result_ = SkillResult{request.id, SkillResult::Outcome::kRefused, reason};
  };
  if (request_) return refuse("it is busy: " + phase_);
  if (leave != Leave::kMove) return refuse(kHolds);
  if (!command_) return refuse("the arm's device is silent");
  const auto problem = WhyNot(request);
  if (problem) return refuse(*problem);
  request_ = request;
  peak_force_ = 0;
  has_moved_ = false;
  failure_.clear();
  // What an earlier life or a stop has left it at: by now it is known where
  // parts are.
  if (!std::exchange(knows_place_, true)) {
    is_near_ = monitor_.IsNearSomething(command_->q);
  }
  PlanSkill();
}

/// What a skill that was cut short has left the hand at comes first.
void ArmWorker::PlanSkill() {
  todos_.clear();
  if (SiteOfHeld() != nullptr) {
    PlanLetGo();
    return Add(
        "look", [] { return std::unique_ptr<SkillStage>(); },
        [this] { PlanSkill(); });
  }
  if (is_near_) PlanGoFree();
  switch (request_->kind) {
    case SkillRequest::Kind::kInsert:
      return PlanInsert();
    case SkillRequest::Kind::kPresent:
      return PlanPresent();
    case SkillRequest::Kind::kPutDown:
      return PlanPutDown();
    case SkillRequest::Kind::kFetch:
      return PlanTake({});
    case SkillRequest::Kind::kGoHome:
      return PlanGoHome();
    case SkillRequest::Kind::kGoFree:
      // It may be asked for nothing else for long: the room is the other's.
      if (!held_) PlanGoHome();
      return;
  }
}

std::optional<std::string> ArmWorker::WhyNot(
    const SkillRequest& request) const {
  if (!held_ && reading_.is_gripping) return "nobody knows what it holds";
  // It may be held by a site as well.
  if (held_ && !monitor_.poses().contains(held_->part)) {
    return "nobody knows where " + held_->part + " is";
  }
  if (request.kind == SkillRequest::Kind::kGoHome ||
      request.kind == SkillRequest::Kind::kGoFree) {
    return std::nullopt;
  }
  if (params_.parts.Find(request.part) == nullptr) {
    return "there is no part '" + request.part + "'";
  }
  if (held_ && held_->part != request.part && SiteOfHeld() == nullptr) {
    return "it holds " + held_->part;
  }
  if (!monitor_.poses().contains(request.part)) {
    return "nobody knows where " + request.part + " is";
  }
  if (request.kind != SkillRequest::Kind::kInsert) return std::nullopt;
  const Site* site = params_.parts.FindSite(request.site);
  if (site == nullptr) return "there is no site '" + request.site + "'";
  if (!params_.layout.FindArm(params_.arm)->X_FS) {
    return "it has no force-torque sensor";
  }
  if (!monitor_.poses().contains(site->host)) {
    return "nobody knows where " + site->host + " is";
  }
  return std::nullopt;
}

ArmCommand ArmWorker::Step(const ArmReading& reading, Leave leave, double dt) {
  reading_ = reading;
  if (!command_)
    command_ = ArmCommand{reading.q, reading.opening, reading.stance};
  still_ = reading.dq.cwiseAbs().maxCoeff() < kStill ? still_ + dt : 0;
  if (params_.layout.FindArm(params_.arm)->X_FS) sensor_.Update(reading, dt);
  KnowHeld();
  reachable_.Step(dt);
  if (reading.is_stopped && request_) {
    End(SkillResult::Outcome::kStopped,
        "protective stop: " + reading.why_stopped);
    // Nothing need be as it was: all is found out again.
    ForgetHeld();
    knows_place_ = false;
  }
  if (reading.is_stopped) command_->q = reading.q;
  is_frozen_ = leave == Leave::kFreeze || reading.is_stopped;
  const bool stands = is_frozen_ || Waits(dt);
  rate_ = stands ? 0 : std::min(1.0, rate_ + dt / kStartTime);
  if (request_ && !stands) Advance(rate_ * dt);
  return *command_;
}

/// Before it would come too near: people come first, then the arm that inserts.
bool ArmWorker::Waits(double dt) {
  const ArmPosture now{command_->q, command_->grip, command_->opening};
  SceneMonitor::WayAhead way;
  for (const double seconds : kLookAhead) {
    if (stage_) way.push_back(stage_->Ahead(seconds, command_->q));
  }
  const bool is_person_there = stage_ && monitor_.MeetsPerson(now, way);
  TakeOtherWay(dt);
  if (Heeds(way_of_people_.Step(is_person_there, dt), kPersonInTheWay)) {
    return true;
  }
  const bool is_other_there = stage_ && monitor_.MeetsOther(now, way);
  return Heeds(way_of_others_.Step(is_other_there, dt),
               "another arm is in the way");
}

/// True if it stands still in this tick.
bool ArmWorker::Heeds(RightOfWay::Advice advice, const std::string& reason) {
  if (advice == RightOfWay::Advice::kGoAround) GoAround();
  if (advice == RightOfWay::Advice::kGiveUp) OnFailure(reason);
  return advice != RightOfWay::Advice::kGo;
}

/// If there is no other way it keeps to the one that it has.
void ArmWorker::GoAround() {
  if (!stage_ || !stage_->HasOtherWays()) return;
  Todo::Made made = todos_.front().make();
  if (auto* stage = std::get_if<std::unique_ptr<SkillStage>>(&made)) {
    other_way_ = std::move(*stage);
  }
}

/// As long as it stands where it asked from.
void ArmWorker::TakeOtherWay(double dt) {
  if (!other_way_) return;
  switch (other_way_->Prepare(dt)) {
    case SkillStage::State::kWaiting:
      return;
    case SkillStage::State::kFailed:
      return other_way_.reset();
    default:
      stage_ = std::move(other_way_);
  }
}

void ArmWorker::Advance(double dt) {
  if (!stage_ && !BeginNext()) return;
  other_way_.reset();
  switch (stage_->Step(reading_, dt, &*command_)) {
    case SkillStage::State::kWaiting:
      return;
    case SkillStage::State::kRunning:
      has_moved_ |= dt > 0;
      return;
    case SkillStage::State::kFailed:
      return OnFailure(stage_->reason());
    case SkillStage::State::kDone:
      stage_.reset();
      FinishFirst();
  }
}

/// Makes the next stage; false if there is none to be run in this tick.
bool ArmWorker::BeginNext() {
  while (!todos_.empty()) {
    phase_ = todos_.front().phase;
    Todo::Made made = todos_.front().make();
    if (auto* reason = std::get_if<std::string>(&made)) {
      OnFailure(*reason);
      return false;
    }
    stage_ = std::move(std::get<std::unique_ptr<SkillStage>>(made));
    if (stage_) return true;
    FinishFirst();
  }
  using Outcome = SkillResult::Outcome;
  const Outcome not_done = has_yielded_ ? Outcome::kYielded : Outcome::kFailed;
  End(failure_.empty() ? Outcome::kSucceeded : not_done, failure_);
  return false;
}

void ArmWorker::FinishFirst() {
  const auto then = std::move(todos_.front().then);
  todos_.pop_front();
  if (then) then();
}

/// Draws back from what is near, then the skill has failed.
void ArmWorker::OnFailure(const std::string& reason) {
  stage_.reset();
  other_way_.reset();
  todos_.clear();
  using Outcome = SkillResult::Outcome;
  const bool is_person = reason == kPersonInTheWay;
  if (!has_moved_) {
    return End(is_person ? Outcome::kYielded : Outcome::kRefused, reason);
  }
  if (!failure_.empty()) {
    return End(SkillResult::Outcome::kFailed,
               fmt::format("{}; and then: {}", failure_, reason));
  }
  failure_ = reason;
  has_yielded_ = is_person;
  if (is_near_ && !held_ && !reading_.is_gripping) {
    const double open = command_->opening + 2 * kLetGoMargin;
    Add("open", [=, this] { return Fingers(open, Until::kThere); });
  }
  if (SiteOfHeld() != nullptr) {
    PlanLetGo();
  } else if (is_near_) {
    PlanDrawBack();
  }
  // Who only passes parts on leaves the room to the other.
  if (request_->kind != SkillRequest::Kind::kInsert) PlanGoHome();
}

void ArmWorker::End(SkillResult::Outcome outcome, const std::string& reason) {
  result_ = SkillResult{request_->id, outcome, reason, peak_force_};
  request_.reset();
  todos_.clear();
  stage_.reset();
  other_way_.reset();
  phase_.clear();
}

std::optional<SkillResult> ArmWorker::TakeResult() {
  return std::exchange(result_, std::nullopt);
}

std::string ArmWorker::held() const {
  const bool is_placed = !request_ && SiteOfHeld() != nullptr;
  return held_ && !is_placed ? held_->part : "";
}

/// The site that holds what the gripper holds; nullptr if there is none.
const Site* ArmWorker::SiteOfHeld() const {
  return held_ ? FindHoldingSite(held_->part, params_.parts, monitor_.poses())
               : nullptr;
}

/// The hand is empty, or nobody knows what is in it.
void ArmWorker::ForgetHeld() {
  held_.reset();
  sensor_.Unload();
  monitor_.SetHeld(std::nullopt);
}

void ArmWorker::Hold(const std::string& name, const Isometry3d& X_GO) {
  held_ = HeldPart{name, X_GO, grasp_.grip, grasp_.width};
  const Part& part = *params_.parts.Find(name);
  const VolumeMoments moments = MomentsOf(part.pieces);
  sensor_.Load(part.density * moments.volume, X_GO * moments.centre);
}

/// What the fingers hold if they held it before this life began, or have lost.
void ArmWorker::KnowHeld() {
  if (!reading_.is_gripping) {
    if (!held_ || phase_ == kLetGo) return;
    const std::string lost = "it has lost " + held_->part;
    ForgetHeld();
    if (request_) OnFailure(lost);
    return;
  }
  if (held_ || request_ || still_ < kLookTime) return;
  const auto part =
      monitor_.FindGrasped({reading_.q, reading_.stance, reading_.opening});
  if (!part) return;
  grasp_.grip = reading_.stance;
  grasp_.width = reading_.opening;
  const Isometry3d X_WG = kinematics_.GripperPose(reading_.q);
  Hold(*part, X_WG.inverse() * monitor_.poses().at(*part));
}

}  // namespace cell::robot_arm
