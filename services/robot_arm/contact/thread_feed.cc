#include "services/robot_arm/contact/thread_feed.h"

#include <Eigen/Geometry>
#include <numbers>

namespace cell::robot_arm {

MotionReference::Step ThreadFeed::Advance(const ContactState& /*state*/,
                                          double rate, double dt) {
  angle_ += rate * params_.rate * dt;
  const double sink = pitch_ * params_.rate / (2 * std::numbers::pi);  // [m/s]
  Step step{.turned = angle_, .is_pressing = true};
  step.translation.z() = -(rate * sink) * dt;
  step.R_SO = Eigen::AngleAxisd(-angle_, Eigen::Vector3d::UnitZ()) * R_SO_;
  return step;
}

}  // namespace cell::robot_arm
