#include "services/robot_arm/arm.h"

#include <utility>

#include "common/geometry/part_shape.h"
#include "services/robot_arm/fastening.h"

namespace cell::robot_arm {
namespace {

constexpr double kStill = 1e-3;    // [rad/s]
constexpr double kLookTime = 0.3;  // [s] at rest, before tracks show it there

}  // namespace

Arm::Arm(const Params& params)
    : params_(params),
      layout_(*params_.layout.FindArm(params.arm)),
      kinematics_(layout_),
      sensor_(kinematics_, layout_, params_.settings.force_sensor),
      monitor_({params.arm, params.layout, params.parts,
                params.settings.motion.clearance, params.settings.distances}) {}

void Arm::Update(const ArmReading& reading, double dt) {
  reading_ = reading;
  if (!command_) {
    command_ = ArmCommand{reading.q, reading.opening, reading.stance};
  }
  still_ = reading.dq.cwiseAbs().maxCoeff() < kStill ? still_ + dt : 0;
  if (has_force_sensor()) sensor_.Update(reading, dt);
}

void Arm::Hold(HeldPart held) {
  const Part& part = *params_.parts.Find(held.part);
  const VolumeMoments moments = MomentsOf(part.pieces);
  sensor_.Load(part.density * moments.volume, held.X_GO * moments.centre);
  held_ = std::move(held);
}

void Arm::ForgetHeld() {
  held_.reset();
  is_releasing = false;
  sensor_.Unload();
  monitor_.SetHeld(std::nullopt);
}

const Site* Arm::SiteOfHeld() const {
  return held_ ? FindHoldingSite(held_->part, parts(), poses()) : nullptr;
}

std::optional<std::string> Arm::FindGrasped() const {
  return monitor_.FindGrasped({reading_.q, reading_.stance, reading_.opening});
}

void Arm::RecogniseHeld() {
  if (still_ < kLookTime) return;
  const auto part = FindGrasped();
  if (!part) return;
  const Eigen::Isometry3d X_WG = kinematics_.GripperPose(reading_.q);
  Hold({*part, X_WG.inverse() * poses().at(*part), reading_.stance,
        reading_.opening});
}

}  // namespace cell::robot_arm
