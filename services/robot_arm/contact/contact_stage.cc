#include "services/robot_arm/contact/contact_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell::robot_arm {

using Eigen::Isometry3d;

ContactStage::ContactStage(const ToolKinematics& kinematics,
                           const ContactSensor& sensor,
                           const SiteFrames& frames, ContactMotionMaker maker,
                           double* peak_force)
    : kinematics_(kinematics),
      sensor_(sensor),
      frames_(frames),
      maker_(std::move(maker)),
      peak_force_(peak_force) {}

SkillStage::State ContactStage::Step(const ArmReading& reading, double dt,
                                     ArmCommand* command) {
  if (!motion_) {
    motion_.emplace(maker_(frames_, kinematics_.GripperPose(command->q)));
  }
  silence_ = sensor_.weightless() ? 0 : silence_ + dt;
  if (silence_ > sensor_.params().patience) {
    reason_ = fmt::format(
        "the wrist force-torque sensor has been silent for more than the {} s "
        "allowed (force_sensor.patience_s)",
        sensor_.params().patience);
    return State::kFailed;
  }
  if (!sensor_.weightless()) return State::kRunning;
  const Isometry3d X_WG = kinematics_.GripperPose(reading.q);
  const ContactWrench contact = sensor_.ContactAt(
      (X_WG * frames_.X_GO).translation(), frames_.X_WS.linear());
  const ContactMotion::State state =
      motion_->Step(contact, frames_.HeightAt(X_WG), dt);
  *peak_force_ = std::max(*peak_force_, motion_->peak_force());
  if (state == ContactMotion::State::kFailed) {
    reason_ = motion_->reason();
    return State::kFailed;
  }
  const auto q = kinematics_.JointsNear(frames_.GripperAt(motion_->PartPose()),
                                        command->q);
  if (!q) {
    reason_ = "the path to the site leads out of reach";
    return State::kFailed;
  }
  command->q = *q;
  return state == ContactMotion::State::kDone ? State::kDone : State::kRunning;
}

}  // namespace cell::robot_arm
