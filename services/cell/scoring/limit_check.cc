#include "services/cell/scoring/limit_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/arms/arm_bodies.h"
#include "common/bus/bus.h"
#include "common/kinematics/joint_values.h"

namespace cell::cli {
namespace {

using Kind = Violation::Kind;

constexpr double kTick = 1e-6 * kTickUs;  // [s]
constexpr double kRounding = 1e-6;        // [rad], [rad/s], [m]
constexpr double kMoves = 1e-3;           // [rad/s] faster than standing still

LimitCheck::Breach WrongNumber(const std::string& subject,
                               const std::string& reason) {
  return {Kind::kPosition, subject, "has " + reason};
}

std::string JointName(int index) {
  return fmt::format("joint {}", index + 1);
}

}  // namespace

std::vector<LimitCheck::Breach> LimitCheck::OnState(const arm_state_t& state) {
  const JointLimits& limits = arm_.model->limits();
  std::vector<Breach> breaches;
  const auto position = JointsFromMessage(state.position, *arm_.model);
  if (!position) return {WrongNumber("state", position.reason())};
  const auto velocity = JointsFromMessage(state.velocity, *arm_.model);
  if (!velocity) return {WrongNumber("state", velocity.reason())};
  const Joints& q = *position;
  const double speed = velocity->cwiseAbs().maxCoeff();
  for (int i = 0; i < kNumJoints; ++i) {
    // NaN exceeds every limit.
    if (!(std::abs(q[i]) <= limits.angle[i] + kRounding)) {
      breaches.push_back({Kind::kPosition, JointName(i),
                          fmt::format("is at {:.3f} rad", q[i])});
    }
    if (!(std::abs((*velocity)[i]) <= limits.speed[i] + kRounding)) {
      breaches.push_back(
          {Kind::kSpeed, JointName(i),
           fmt::format("turns at {:.2f} rad/s", std::abs((*velocity)[i]))});
    }
  }
  const Eigen::Vector3d p_WG = GripperPose(arm_, q).translation();
  if (speed > kMoves && arm_.workspace.exteriorDistance(p_WG) > kRounding) {
    breaches.push_back(
        {Kind::kWorkspace, "the gripper",
         fmt::format("moves outside, at ({:.3f}, {:.3f}, {:.3f}) m", p_WG.x(),
                     p_WG.y(), p_WG.z())});
  }
  const bool is_stopped = state.servo == arm_state_t::STOPPED;
  num_stops_ += is_stopped && !is_stopped_;
  is_stopped_ = is_stopped;
  return breaches;
}

std::vector<LimitCheck::Breach> LimitCheck::OnSetpoint(
    const arm_setpoint_t& setpoint) {
  const JointLimits& limits = arm_.model->limits();
  std::vector<Breach> breaches;
  const auto goals = JointsFromMessage(setpoint.position, *arm_.model);
  if (!goals) return {WrongNumber("set-point", goals.reason())};
  for (int i = 0; i < kNumJoints; ++i) {
    const double goal = (*goals)[i];
    if (!(std::abs(goal) <= limits.angle[i] + kRounding)) {
      breaches.push_back({Kind::kPosition, "set-point of " + JointName(i),
                          fmt::format("is {:.3f} rad", goal)});
    }
    // A stopped arm does not follow set-points.
    if (is_stopped_ || !last_ ||
        last_->header.sender != setpoint.header.sender) {
      continue;
    }
    const int32_t num_ticks = setpoint.header.tick - last_->header.tick;
    const double step =
        std::abs(goal - last_->position[static_cast<size_t>(i)]);
    if (!(step <= limits.speed[i] * kTick * num_ticks + kRounding)) {
      breaches.push_back({Kind::kSetpoint, "set-point of " + JointName(i),
                          fmt::format("jumps by {:.4f} rad in {} ms", step,
                                      num_ticks * kTickUs / 1000)});
    }
  }
  last_ = setpoint;
  return breaches;
}

void LimitCheck::Restart() {
  last_.reset();
  is_stopped_ = false;
}

}  // namespace cell::cli
