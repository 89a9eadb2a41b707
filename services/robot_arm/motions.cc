#include "services/robot_arm/motions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/arms/straight_line.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;

constexpr double kTurnSpeed = 0.8;     // [rad/s] of the gripper on a line
constexpr double kSettleTime = 0.12;   // [s] that the servos need
constexpr double kThere = 0.0015;      // [rad] of a joint
constexpr double kSettlingTime = 1.0;  // [s] for the servos
constexpr double kFingerTime = 3.0;    // [s] for the fingers
constexpr double kFingerThere = 5e-4;  // [m]
constexpr double kDwell = 0.15;        // [s] after the fingers
constexpr double kStill = 0.15;        // [s] before a sensor is read
constexpr int kNumReadings = 12;
constexpr double kSensorPatience = 0.2;  // [s] without a reading

double MinimumJerk(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * (10 + t * (-15 + 6 * t));
}
constexpr double kMinimumJerkPeak = 1.875;  // of the mean speed

bool IsThere(const ArmReading& reading, const ArmCommand& command) {
  return (reading.q - command.q).cwiseAbs().maxCoeff() < kThere;
}

}  // namespace

SkillStage::State AwaitPlan::Step(const ArmReading&, double dt, ArmCommand*) {
  switch (inquiry_.Step(dt)) {
    case MotionInquiry::State::kWaiting:
      return State::kWaiting;
    case MotionInquiry::State::kFound:
      use_(inquiry_.plan());
      return State::kDone;
    case MotionInquiry::State::kNone:
      break;
  }
  return State::kFailed;
}

FollowWay::FollowWay(MotionClient& client, const MotionRequest& request,
                     const JointRates& rates)
    : inquiry_(client, request), rates_(rates) {}

SkillStage::State FollowWay::Prepare(double dt) {
  if (trajectory_) return State::kRunning;
  switch (inquiry_.Step(dt)) {
    case MotionInquiry::State::kWaiting:
      return State::kWaiting;
    case MotionInquiry::State::kFound:
      if (inquiry_.plan().waypoints.empty()) return State::kFailed;
      trajectory_.emplace(inquiry_.plan().waypoints, rates_);
      return State::kRunning;
    case MotionInquiry::State::kNone:
      break;
  }
  return State::kFailed;
}

SkillStage::State FollowWay::Step(const ArmReading& reading, double dt,
                                  ArmCommand* command) {
  const State prepared = Prepare(dt);
  if (prepared != State::kRunning) return prepared;
  time_ += dt;
  command->q = trajectory_->At(time_).q;
  if (time_ < trajectory_->duration()) return State::kRunning;
  settling_ += dt;
  const bool is_over =
      settling_ >= kSettleTime &&
      (IsThere(reading, *command) || settling_ > kSettlingTime);
  return is_over ? State::kDone : State::kRunning;
}

std::optional<Joints> FollowWay::Ahead(double seconds,
                                       const Joints& /*q*/) const {
  if (!trajectory_) return std::nullopt;
  return trajectory_->At(time_ + seconds).q;
}

MoveOnLine::MoveOnLine(const ToolKinematics& kinematics, const Isometry3d& X_WG,
                       double speed)
    : kinematics_(kinematics), X_WG_to_(X_WG), speed_(speed) {}

SkillStage::State MoveOnLine::Step(const ArmReading& reading, double dt,
                                   ArmCommand* command) {
  if (!has_begun_) {
    has_begun_ = true;
    X_WG_from_ = kinematics_.GripperPose(command->q);
    const double way =
        (X_WG_to_.translation() - X_WG_from_.translation()).norm();
    const double angle =
        Eigen::AngleAxisd(X_WG_from_.linear().transpose() * X_WG_to_.linear())
            .angle();
    duration_ = kMinimumJerkPeak * std::max(way / speed_, angle / kTurnSpeed);
  }
  time_ += dt;
  const auto q = kinematics_.JointsNear(PoseAt(time_), command->q);
  if (!q) {
    reason_ = "the straight path leads out of reach";
    return State::kFailed;
  }
  command->q = *q;
  const bool is_over =
      time_ >= duration_ + kSettleTime &&
      (IsThere(reading, *command) || time_ > duration_ + kSettlingTime);
  return is_over ? State::kDone : State::kRunning;
}

Isometry3d MoveOnLine::PoseAt(double time) const {
  const double share = duration_ > 0 ? MinimumJerk(time / duration_) : 1;
  return PoseBetween(X_WG_from_, X_WG_to_, share);
}

std::optional<Joints> MoveOnLine::Ahead(double seconds, const Joints& q) const {
  if (!has_begun_) return std::nullopt;
  return kinematics_.JointsNear(PoseAt(time_ + seconds), q);
}

SkillStage::State WaitForPerson::Step(const ArmReading&, double dt,
                                      ArmCommand*) {
  if (!is_in_the_way_()) return State::kDone;
  time_ += dt;
  return time_ < patience_ ? State::kWaiting : State::kFailed;
}

MoveFingers::MoveFingers(double opening, const std::string& grip, Until until)
    : opening_(opening), grip_(grip), until_(until) {}

SkillStage::State MoveFingers::Step(const ArmReading& reading, double dt,
                                    ArmCommand* command) {
  time_ += dt;
  command->opening = opening_;
  command->grip = grip_;
  if (time_ < kDwell) return State::kRunning;
  const bool is_there = std::abs(reading.opening - opening_) < kFingerThere;
  switch (until_) {
    case Until::kGripping:
      if (reading.is_gripping) return State::kDone;
      return is_there || time_ > kFingerTime ? State::kFailed : State::kRunning;
    case Until::kReleased:
      if (!reading.is_gripping && is_there) return State::kDone;
      break;
    case Until::kThere:
      if (is_there) return State::kDone;
      break;
  }
  return time_ > kFingerTime ? State::kFailed : State::kRunning;
}

Failure MoveFingers::failure() const {
  return {until_ == Until::kGripping ? "the fingers have closed on nothing"
                                     : "the fingers do not move"};
}

SkillStage::State Tare::Step(const ArmReading&, double dt, ArmCommand*) {
  time_ += dt;
  if (time_ < kStill) return State::kRunning;
  if (!sensor_.weightless()) {
    return time_ > kStill + kSensorPatience ? State::kFailed : State::kRunning;
  }
  const ArmReading::SensedWrench& wrench = *sensor_.weightless();
  sum_.force += wrench.force;
  sum_.torque += wrench.torque;
  if (++num_ < kNumReadings) return State::kRunning;
  sensor_.SetOffset({sum_.force / num_, sum_.torque / num_});
  return State::kDone;
}

Failure Tare::failure() const {
  return {
      "the wrist force-torque sensor has been silent for more than the "
      "0.2 s allowed"};
}

}  // namespace cell::robot_arm
