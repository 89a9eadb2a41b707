#include "services/robot_arm/contact/admittance.h"

namespace cell::robot_arm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

template <class V>
V Limited(const V& v, double length) {
  const double norm = v.norm();
  return norm > length ? V(v * (length / norm)) : v;
}

}  // namespace

void Admittance::Step(const ContactWrench& contact, double dt) {
  const Vector2d sideways = contact.force.head<2>();
  proportional_ = params_.kp * sideways;
  integral_ = Limited<Vector2d>(integral_ + params_.ki * dt * sideways,
                                params_.max_drift);
  turn_proportional_ = params_.kp_turn * contact.torque;
  turn_integral_ = Limited<Vector3d>(
      turn_integral_ + params_.ki_turn * dt * contact.torque, params_.max_turn);
}

double Admittance::AxialStep(double error, double rate, double dt) const {
  const double speed = params_.ki * error;
  return (speed < 0 ? rate * speed : speed) * dt;
}

}  // namespace cell::robot_arm
