#include "services/robot_arm/contact_sensor.h"

#include <numbers>

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

const Vector3d kGravity_W(0, 0, -9.81);  // [m/s^2]

}  // namespace

ContactSensor::ContactSensor(const ToolKinematics& kinematics,
                             const ArmLayout& layout, const Params& params)
    : kinematics_(kinematics), params_(params), X_FG_(layout.X_FG) {
  bodies_[0].mass = layout.tool_mass;
  bodies_[0].p_F = layout.p_F_tool;
}

void ContactSensor::Load(double mass, const Vector3d& p_G) {
  bodies_[1] = {mass, X_FG_ * p_G, {}};
}

/// Weight and inertia, in W.
Vector3d ContactSensor::ForceOn(Body& body, const Vector3d& p_W, double dt) {
  Vector3d acceleration = Vector3d::Zero();
  if (body.p_W[1]) {
    acceleration = (p_W - 2 * *body.p_W[0] + *body.p_W[1]) / (dt * dt);
  }
  body.p_W[1] = body.p_W[0];
  body.p_W[0] = p_W;
  return body.mass * (kGravity_W - acceleration);
}

void ContactSensor::Update(const ArmReading& reading, double dt) {
  X_WS_ = kinematics_.SensorPose(reading.q);
  const Isometry3d X_WF = kinematics_.GripperPose(reading.q) * X_FG_.inverse();
  weightless_ = reading.wrench;
  for (Body& body : bodies_) {
    const Vector3d p_W = X_WF * body.p_F;
    const Vector3d force = X_WS_.linear().transpose() * ForceOn(body, p_W, dt);
    if (!weightless_) continue;
    weightless_->force -= force;
    weightless_->torque -= (X_WS_.inverse() * p_W).cross(force);
  }
  if (!weightless_) return;
  const double share =
      1 / (1 + 1 / (2 * std::numbers::pi * params_.cutoff * dt));
  if (!smooth_) smooth_ = weightless_;
  smooth_->force += share * (weightless_->force - smooth_->force);
  smooth_->torque += share * (weightless_->torque - smooth_->torque);
  weightless_ = smooth_;
}

ContactWrench ContactSensor::ContactAt(const Vector3d& p_W,
                                       const Eigen::Matrix3d& R_WA) const {
  const Vector3d force = weightless_->force - offset_.force;
  const Vector3d p_S = X_WS_.inverse() * p_W;
  const Vector3d torque =
      weightless_->torque - offset_.torque - p_S.cross(force);
  const Eigen::Matrix3d R_AS = R_WA.transpose() * X_WS_.linear();
  return {R_AS * force, R_AS * torque};
}

}  // namespace cell::robot_arm
