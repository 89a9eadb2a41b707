#include "services/robot_arm/seating.h"

#include <algorithm>

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kSensorPatience = 0.05;  // [s] without a reading
constexpr char kNoSensor[] =
    "the wrist force-torque sensor has been silent for more than the 0.05 s "
    "allowed";
constexpr char kNoWay[] = "the way to the site leads out of reach";

}  // namespace

Isometry3d SeatingFrames::GripperAt(const Isometry3d& X_SO) const {
  return X_WS * X_SO * X_symmetry * X_GO.inverse();
}

double SeatingFrames::HeightAt(const Isometry3d& X_WG) const {
  return (X_WS.inverse() * (X_WG * X_GO).translation()).z();
}

Insert::Insert(const ToolKinematics& kinematics, const SeatingFrames& frames,
               const Insertion::Params& params, const ContactSensor& sensor,
               double* peak_force)
    : kinematics_(kinematics),
      frames_(frames),
      params_(params),
      sensor_(sensor),
      peak_force_(peak_force) {}

SkillStage::State Insert::Step(const ArmReading& reading, double dt,
                               ArmCommand* command) {
  const Isometry3d X_WG = kinematics_.GripperPose(reading.q);
  if (!insertion_) {
    insertion_.emplace(params_,
                       frames_.HeightAt(kinematics_.GripperPose(command->q)));
  }
  silence_ = sensor_.weightless() ? 0 : silence_ + dt;
  if (silence_ > kSensorPatience) {
    reason_ = kNoSensor;
    return State::kFailed;
  }
  if (!sensor_.weightless()) return State::kRunning;
  const ContactWrench contact = sensor_.ContactAt(
      (X_WG * frames_.X_GO).translation(), frames_.X_WS.linear());
  const Insertion::State state =
      insertion_->Step(contact, frames_.HeightAt(X_WG), dt);
  *peak_force_ = std::max(*peak_force_, insertion_->peak_force());
  reason_ = insertion_->reason();
  if (state == Insertion::State::kFailed) return State::kFailed;
  const auto q =
      kinematics_.JointsNear(frames_.GripperAt(insertion_->X_SO()), command->q);
  if (!q) {
    reason_ = kNoWay;
    return State::kFailed;
  }
  command->q = *q;
  return state == Insertion::State::kDone ? State::kDone : State::kRunning;
}

Turn::Turn(const ToolKinematics& kinematics, const SeatingFrames& frames,
           const Turning::Params& params, const ContactSensor& sensor)
    : kinematics_(kinematics),
      frames_(frames),
      params_(params),
      sensor_(sensor) {}

SkillStage::State Turn::Step(const ArmReading& reading, double dt,
                             ArmCommand* command) {
  const Isometry3d X_WG = kinematics_.GripperPose(reading.q);
  if (!turning_) {
    const Isometry3d X_SO = frames_.X_WS.inverse() *
                            kinematics_.GripperPose(command->q) * frames_.X_GO *
                            frames_.X_symmetry.inverse();
    turning_.emplace(params_, X_SO);
  }
  silence_ = sensor_.weightless() ? 0 : silence_ + dt;
  if (silence_ > kSensorPatience) {
    reason_ = kNoSensor;
    return State::kFailed;
  }
  if (!sensor_.weightless()) return State::kRunning;
  const ContactWrench contact = sensor_.ContactAt(
      (X_WG * frames_.X_GO).translation(), frames_.X_WS.linear());
  const Turning::State state =
      turning_->Step(contact, frames_.HeightAt(X_WG), dt);
  reason_ = turning_->reason();
  if (state == Turning::State::kFailed) return State::kFailed;
  const auto q =
      kinematics_.JointsNear(frames_.GripperAt(turning_->X_SO()), command->q);
  if (!q) {
    reason_ = kNoWay;
    return State::kFailed;
  }
  command->q = *q;
  return state == Turning::State::kDone ? State::kDone : State::kRunning;
}

}  // namespace cell::robot_arm
