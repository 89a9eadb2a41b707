#include "services/robot_arm/robot_arm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cell/arm_setpoint_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/arms/cell_check.h"
#include "common/arms/motion_messages.h"
#include "common/kinematics/joint_values.h"
#include "common/layout/limit_words.h"
#include "common/scene/track.h"
#include "common/skills/skill_arguments.h"
#include "common/task/task.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

constexpr double kTick = 1e-6 * kTickUs;      // [s]
constexpr int32_t kReportPeriod = 12;         // ticks
constexpr int64_t kSetpointUs = 4 * kTickUs;  // how long one may be followed
constexpr int64_t kFreshUs = 2 * kTickUs;     // a reading of the sensor

Result<ArmReading> FromMessage(const arm_state_t& message,
                               const ArmModel& model) {
  const auto q = AnglesFromMessage(message.position, model);
  if (!q) return Reason{q.reason()};
  const auto dq = JointsFromMessage(message.velocity, model);
  if (!dq) return Reason{dq.reason()};
  if (!(dq->cwiseAbs().array() <= 2 * model.limits().speed.array()).all()) {
    return Reason{"faster than twice the speed of a " + model.name()};
  }
  if (!(message.opening >= 0 && message.opening < 1) ||
      message.grip < arm_state_t::OPEN ||
      message.grip > arm_state_t::GRIPPING ||
      message.servo < arm_state_t::FOLLOWING ||
      message.servo > arm_state_t::STOPPED) {
    return Reason{"an impossible opening, grip or servo"};
  }
  ArmReading reading;
  reading.q = *q;
  reading.dq = *dq;
  reading.opening = message.opening;
  reading.stance = message.stance;
  reading.is_gripping = message.grip == arm_state_t::GRIPPING;
  reading.is_stopped = message.servo == arm_state_t::STOPPED;
  return reading;
}

bool IsSame(const arm_report_t& a, const arm_report_t& b) {
  return a.request == b.request && a.phase == b.phase &&
         a.contact == b.contact && a.held == b.held &&
         a.is_frozen == b.is_frozen &&
         a.is_held_by_operator == b.is_held_by_operator &&
         a.reachable == b.reachable;
}

bool IsPersonsHand(const CellLayout& layout, const std::string& name) {
  return std::ranges::find(layout.hands, name, &CellLayout::Hand::name) !=
         layout.hands.end();
}

std::vector<skill_traits_t> TraitsOf(const ArmLayout& arm) {
  std::vector<skill_traits_t> skills;
  for (const Skill* skill : SkillsOf(arm.X_FS.has_value())) {
    const SkillTraits traits = skill->traits();
    skills.push_back({skill->name(), traits.may_run_beside, traits.hands_over,
                      traits.needs_force_sensor});
  }
  return skills;
}

}  // namespace

RobotArm::RobotArm(Bus& bus, const Params& params)
    : bus_(bus),
      params_(params),
      name_(params.worker.arm),
      suffix_(ChannelSuffix(name_)),
      skills_(TraitsOf(*params.worker.layout.FindArm(name_))),
      worker_(std::make_unique<ArmWorker>(params_.worker)),
      alerts_(bus) {
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const auto& m) { return OnEpisode(m); });
  bus.Subscribe<motion_permit_t>(
      "MOTION_PERMIT", [this](const auto& m) { return OnPermit(m); }, 1);
  bus.Subscribe<tracks_t>(
      "TRACKS", [this](const auto& m) { return OnTracks(m); }, 1);
  bus.Subscribe<asked_skill_t>("SKILL_REQUEST",
                               [this](const auto& m) { return OnRequest(m); });
  bus.Subscribe<motion_plan_t>("MOTION_PLAN",
                               [this](const auto& m) { return OnPlan(m); });
  for (const ArmLayout& arm : params_.worker.layout.arms) {
    bus.Subscribe<arm_state_t>(
        "ARM_STATE_" + ChannelSuffix(arm.name),
        [this, arm = arm.name](const arm_state_t& m) {
          return arm == name_ ? OnState(m) : OnOther(arm, m);
        },
        1);
    if (arm.name == name_) {
      bus_.Subscribe<arm_stop_t>("ARM_STOP_" + suffix_,
                                 [this](const auto& m) { return OnStop(m); });
    }
    if (arm.name == name_ && arm.X_FS) {
      bus.Subscribe<wrench_t>(
          "WRENCH_" + suffix_, [this](const auto& m) { return OnWrench(m); },
          1);
    }
  }
  bus.Every(1, 0, [this] { OnTick(); });
}

bool RobotArm::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) {
    worker_ = std::make_unique<ArmWorker>(params_.worker);
    start_utime_ = bus_.now();
    last_report_ = {};
    was_held_ = false;
  }
  return event.has_value();
}

const ArmModel& RobotArm::ModelOf(const std::string& arm) const {
  return *params_.worker.layout.FindArm(arm)->model;
}

bool RobotArm::OnState(const arm_state_t& message) {
  auto reading = FromMessage(message, ModelOf(name_));
  if (!reading) {
    return alerts_.Reject("ARM_STATE_" + suffix_, reading.reason());
  }
  reading_ = *std::move(reading);
  if (!reading_->is_stopped) why_stopped_ = "its device gave no reason";
  return true;
}

bool RobotArm::OnStop(const arm_stop_t& message) {
  const auto why = WhyStopped(message);
  if (!why || message.arm != name_) return false;
  why_stopped_ = *why;
  return true;
}

bool RobotArm::OnOther(const std::string& arm, const arm_state_t& message) {
  const auto reading = FromMessage(message, ModelOf(arm));
  if (!reading) {
    return alerts_.Reject("ARM_STATE_" + ChannelSuffix(arm), reading.reason());
  }
  worker_->UpdateOther(arm, {reading->q, reading->stance, reading->opening},
                       reading->is_gripping);
  return true;
}

bool RobotArm::OnWrench(const wrench_t& message) {
  ArmReading::SensedWrench wrench;
  std::copy_n(message.force, 3, wrench.force.data());
  std::copy_n(message.torque, 3, wrench.torque.data());
  if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return false;
  wrench_ = {wrench, bus_.now()};  // the message's stamp may be wrong
  return true;
}

bool RobotArm::OnPermit(const motion_permit_t& message) {
  if (message.hold < motion_permit_t::NONE ||
      message.hold > motion_permit_t::AT_ONCE ||
      message.mode < motion_permit_t::IDLE ||
      message.mode > motion_permit_t::HOLD) {
    return false;
  }
  permit_ = message;
  return true;
}

bool RobotArm::OnTracks(const tracks_t& message) {
  const auto tracks = TracksFromMessage(message, params_.scene_objects);
  if (!tracks) return false;
  std::map<std::string, Eigen::Isometry3d> poses;
  std::vector<Eigen::Vector3d> hands;
  for (const Track& track : tracks->tracks) {
    if (params_.scene_objects.IsPart(track.name) &&
        track.state != Track::State::kLost) {
      poses.emplace(track.name, track.X_WO);
    }
    if (IsPersonsHand(params_.worker.layout, track.name)) {
      hands.insert(hands.end(), track.points.begin(), track.points.end());
    }
  }
  worker_->UpdateParts(poses);
  worker_->UpdateHands(std::move(hands));
  return true;
}

bool RobotArm::OnRequest(const asked_skill_t& message) {
  if (message.arm != name_) return true;
  auto arguments = ArgumentsOf(message);
  if (!arguments) return false;
  const SkillRequest request{message.id, message.skill, *std::move(arguments),
                             message.is_careful != 0};
  if (bus_.now() > message.deadline_utime) {
    PublishResult(
        {request.id, SkillResult::Outcome::kRefused,
         fmt::format("the request arrived {:.3f} s after its "
                     "deadline",
                     1e-6 * (static_cast<double>(bus_.now()) -
                             static_cast<double>(message.deadline_utime)))});
    return true;
  }
  worker_->Begin(request, Permission());
  return true;
}

bool RobotArm::OnPlan(const motion_plan_t& message) {
  if (message.arm != name_) return true;
  const auto plan = FromMessage(message, params_.worker.layout);
  if (!plan) return alerts_.Reject("MOTION_PLAN", plan.reason());
  // Requests of an earlier incarnation have ids like this one's.
  if (start_utime_ && message.header.utime >= *start_utime_) {
    worker_->Put(*plan);
  }
  return true;
}

ArmWorker::MotionPermission RobotArm::Permission() const {
  using P = ArmWorker::MotionPermission;
  if (!permit_ || bus_.now() > permit_->until_utime) return P::kFreeze;
  switch (permit_->hold) {
    case motion_permit_t::AT_ONCE:
      return P::kFreeze;
    case motion_permit_t::AT_BOUNDARY:
      return P::kFinish;
    default:
      return permit_->mode == motion_permit_t::EXECUTE ? P::kMove : P::kFinish;
  }
}

void RobotArm::OnTick() {
  if (!start_utime_) start_utime_ = bus_.now();
  if (!reading_) return;
  reading_->wrench.reset();
  if (wrench_ && bus_.now() - wrench_->utime <= kFreshUs) {
    reading_->wrench = wrench_->wrench;
  }
  reading_->why_stopped = why_stopped_;
  const ArmCommand command = worker_->Step(*reading_, Permission(), kTick);
  PublishSetpoint(command);
  for (const MotionRequest& request : worker_->TakeRequests()) {
    motion_request_t message = ToMessage(request);
    message.header.utime = bus_.now();
    bus_.Publish("MOTION_REQUEST", message);
  }
  if (const auto result = worker_->TakeResult()) PublishResult(*result);
  PublishReport();
}

void RobotArm::PublishSetpoint(const ArmCommand& command) {
  arm_setpoint_t message{};
  message.header.utime = bus_.now();
  message.deadline_utime = bus_.now() + kSetpointUs;
  ToMessage(command.q, &message.num_joints, &message.position);
  message.opening = command.opening;
  message.grip = command.grip;
  // The operator has resumed: the cell was held, and is not any more.
  const bool is_held = Permission() == ArmWorker::MotionPermission::kFreeze;
  message.clear_stop = reading_->is_stopped && was_held_ && !is_held;
  if (is_held || !reading_->is_stopped) was_held_ = is_held;
  bus_.Publish("ARM_SETPOINT_" + suffix_, message);
}

void RobotArm::PublishResult(const SkillResult& result) {
  skill_result_t message{};
  message.header.utime = bus_.now();
  message.id = result.id;
  message.arm = name_;
  message.outcome = static_cast<int8_t>(result.outcome);
  message.reason = result.reason;
  message.peak_force = result.peak_force;
  bus_.Publish("SKILL_RESULT", message);
}

void RobotArm::PublishReport() {
  arm_report_t report{};
  report.header.utime = bus_.now();
  report.arm = name_;
  report.request = worker_->request();
  report.phase = worker_->phase().name;
  report.contact = static_cast<int8_t>(worker_->phase().contact);
  report.is_frozen = worker_->is_frozen();
  report.is_held_by_operator = permit_ && permit_->is_held_by_operator;
  report.held = worker_->held();
  report.reachable = worker_->Reachable();
  report.num_reachable = static_cast<int32_t>(report.reachable.size());
  report.skills = skills_;
  report.num_skills = static_cast<int32_t>(report.skills.size());
  if (bus_.tick() % kReportPeriod != 0 && IsSame(report, last_report_)) return;
  last_report_ = report;
  bus_.Publish("ARM_REPORT_" + suffix_, report);
}

std::unique_ptr<Service> MakeRobotArm(Bus& bus, const Deployment& deployment,
                                      const std::string& instance) {
  const Task task = LoadTask(deployment);
  const Config layout_config = deployment.OfTask("cell.yaml");
  if (task.layout.FindArm(instance) == nullptr) {
    layout_config["arms"].Fail("there is no arm '" + instance + "'");
  }
  CheckCell(layout_config, task.parts, task.layout);
  const SkillSettings settings =
      SkillSettings::FromConfig(deployment.OfTask("skills.yaml"), task.parts);
  return std::make_unique<RobotArm>(
      bus, RobotArm::Params{{instance, task.layout, task.parts, settings},
                            task.scene_objects});
}

}  // namespace cell::robot_arm
