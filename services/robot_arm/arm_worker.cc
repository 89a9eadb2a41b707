#include "services/robot_arm/arm_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kStartTime = 0.3;  // [s] until full speed after a freeze
constexpr double kLookAhead[] = {0.05, 0.15, 0.3, 0.45};  // [s] for other arms
constexpr double kLetGoMargin = 0.008;  // [m] each finger, beside a seated part
constexpr double kPatience = 15;        // [s] with people's hands
constexpr double kStill = 1e-3;         // [rad/s]
constexpr double kLookTime = 0.3;  // [s] at rest, before tracks show it there

constexpr char kPersonInTheWay[] = "a person's hand is in the way";
constexpr char kHolds[] = "the cell holds";
constexpr char kLetGo[] = "let go";

}  // namespace

ArmWorker::ArmWorker(const Params& params)
    : params_(params),
      kinematics_(*params_.layout.FindArm(params_.arm)),
      sensor_(kinematics_, *params_.layout.FindArm(params_.arm)),
      planner_(params_),
      // Who inserts goes first.
      way_of_others_(params_.layout.FindArm(params_.arm)->X_FS.has_value()),
      way_of_people_(true) {}

void ArmWorker::See(const std::map<std::string, Isometry3d>& poses) {
  poses_ = poses;
  planner_.SetParts(poses_);
}

void ArmWorker::SeeOther(const std::string& arm, const ArmPosture& posture,
                         bool is_gripping) {
  planner_.SetOther(arm, posture, is_gripping);
}

void ArmWorker::SeeHands(std::vector<Vector3d> points) {
  planner_.SetHands(std::move(points));
}

std::vector<std::string> ArmWorker::Reachable() const {
  return planner_.Reachable();
}

// ---- one skill at a time

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
  // What an earlier life has left it at: by now it is known where parts are.
  if (!std::exchange(knows_place_, true)) {
    is_near_ = planner_.IsNearSomething(command_->q);
  }
  PlanSkill();
}

void ArmWorker::PlanSkill() {
  todos_.clear();
  if (is_near_) PlanDrawBack();
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
  }
}

std::optional<std::string> ArmWorker::WhyNot(
    const SkillRequest& request) const {
  if (request.kind == SkillRequest::Kind::kGoHome) return std::nullopt;
  if (params_.parts.Find(request.part) == nullptr) {
    return "there is no part '" + request.part + "'";
  }
  if (held_ && held_->part != request.part) return "it holds " + held_->part;
  if (!held_ && reading_.is_gripping) return "nobody knows what it holds";
  if (!poses_.contains(request.part)) {
    return "nobody knows where " + request.part + " is";
  }
  if (request.kind != SkillRequest::Kind::kInsert) return std::nullopt;
  const Site* site = params_.parts.FindSite(request.site);
  if (site == nullptr) return "there is no site '" + request.site + "'";
  if (!params_.layout.FindArm(params_.arm)->X_FS) {
    return "it has no force-torque sensor";
  }
  if (!poses_.contains(site->host)) {
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
  planner_.RefreshReachable();
  if (reading.is_stopped && request_) {
    End(SkillResult::Outcome::kStopped,
        "protective stop: the force has grown too high");
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
  ArmPlanner::WayAhead way;
  for (const double seconds : kLookAhead) {
    if (stage_) way.push_back(stage_->Ahead(seconds, command_->q));
  }
  const bool is_person_there = stage_ && planner_.MeetsPerson(now, way);
  if (Heeds(way_of_people_.Step(is_person_there, dt), kPersonInTheWay)) {
    return true;
  }
  const bool is_other_there = stage_ && planner_.MeetsOther(now, way);
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
    stage_ = std::move(*stage);
  }
}

void ArmWorker::Advance(double dt) {
  if (!stage_ && !BeginNext()) return;
  switch (stage_->Step(reading_, dt, &*command_)) {
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
  if (is_near_) PlanDrawBack();
  // Who only passes parts on leaves the room to the other.
  if (request_->kind != SkillRequest::Kind::kInsert) PlanGoHome();
}

void ArmWorker::End(SkillResult::Outcome outcome, const std::string& reason) {
  result_ = SkillResult{request_->id, outcome, reason, peak_force_};
  request_.reset();
  todos_.clear();
  stage_.reset();
  phase_.clear();
}

std::optional<SkillResult> ArmWorker::TakeResult() {
  return std::exchange(result_, std::nullopt);
}

// ---- skills as stages

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
  if (!held_) PlanTake(target);
  PlanCarry(target);
  Add("tare", [this]() -> Todo::Made {
    is_near_ = true;
    return std::make_unique<Tare>(sensor_);
  });
  Add("seat", [this]() -> Todo::Made {
    const Site& site = *params_.parts.FindSite(request_->site);
    return std::make_unique<Insert>(
        kinematics_, FramesAtSite(),
        params_.settings.seatings.at(site.type).insertion, sensor_,
        &peak_force_);
  });
  const Site& site = *params_.parts.FindSite(request_->site);
  if (const Thread* thread = params_.parts.FindThread(site.type)) {
    Add("turn", [this, pitch = thread->pitch]() -> Todo::Made {
      Turning::Params params = params_.settings.turning;
      params.pitch = pitch;
      return std::make_unique<Turn>(kinematics_, FramesAtSite(), params,
                                    sensor_);
    });
  }
  PlanLetGo();
}

/// Where the other arm can take it.
void ArmWorker::PlanPresent() {
  if (!held_) PlanTake({});
  PlanSetDown(params_.layout.FindArm(params_.arm)->exchange,
              ArmPlanner::Taker::kOtherArm);
}

void ArmWorker::PlanPutDown() {
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

void ArmWorker::PlanTake(const TargetMaker& target) {
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
      [this] {
        held_.reset();
        sensor_.Unload();
        planner_.SetHeld(std::nullopt);
      });
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
  const Eigen::Vector2d& aim = params_.settings.seatings.at(site.type).aim;
  target.X_WO = target.X_WO * params_.settings.aim_error.Of(request_->id) *
                Translation3d(aim.x(), aim.y(), 0);
  if (params_.parts.FindThread(site.type) != nullptr) {
    target.turn = -params_.settings.turning.max_angle;
  }
  return target;
}

SeatingFrames ArmWorker::FramesAtSite() const {
  return {target_.X_WO, held_->X_GO, target_.X_WO.inverse() * place_.X_WO};
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
    held_.reset();
    sensor_.Unload();
    if (request_) OnFailure(lost);
    return;
  }
  if (held_ || request_ || still_ < kLookTime) return;
  const auto part =
      planner_.FindGrasped({reading_.q, reading_.stance, reading_.opening});
  if (!part) return;
  grasp_.grip = reading_.stance;
  grasp_.width = reading_.opening;
  const Isometry3d X_WG = kinematics_.GripperPose(reading_.q);
  Hold(*part, X_WG.inverse() * poses_.at(*part));
}

}  // namespace cell
