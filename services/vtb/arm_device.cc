#include "services/vtb/arm_device.h"

#include <algorithm>
#include <cmath>

#include "cell/arm_state_t.hpp"
#include "cell/arm_stop_t.hpp"
#include "cell/wrench_t.hpp"
#include "common/arms/arm_bodies.h"
#include "common/kinematics/joint_values.h"

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kStopPeriod = 62;  // ticks
constexpr double kStill = 1e-4;  // [rad/s]
const Vector3d kGravity(0, 0, -9.81);

}  // namespace

ArmDevice::ArmDevice(Bus& bus, const ArmLayout& layout,
                     const std::vector<PartShape>& shapes, const Params& params)
    : bus_(bus),
      layout_(layout),
      params_(params),
      alerts_(bus),
      suffix_(ChannelSuffix(layout.name)),
      servo_(params.servo, layout.model->limits().speed, layout.home),
      gripper_(layout.gripper, layout.hand, shapes, params.gripper) {
  for (const Part& body : BodyPartsOf(layout)) body_names_.push_back(body.name);
  bus.Subscribe<arm_setpoint_t>(
      "ARM_SETPOINT_" + suffix_,
      [this](const arm_setpoint_t& m) { return OnSetpoint(m); });
}

void ArmDevice::Reset(World& world) {
  servo_ = ArmServo(params_.servo, layout_.model->limits().speed, layout_.home);
  gripper_.Reset(layout_.hand.max_opening / 2);
  force_ = 0;
  const Isometry3d X_WF = FlangePose();
  p_W_tool_[0] = p_W_tool_[1] = X_WF * layout_.p_F_tool;
  const Isometry3d X_WG = X_WF * layout_.X_FG;
  world.hands().Place(layout_.gripper, X_WG, gripper_.opening());
}

bool ArmDevice::OnSetpoint(const arm_setpoint_t& message) {
  if (bus_.now() > message.deadline_utime) return false;
  const auto q = AnglesFromMessage(message.position, *layout_.model);
  if (!q) return alerts_.Reject("ARM_SETPOINT_" + suffix_, q.reason());
  if (!std::isfinite(message.opening)) return false;
  servo_.Command(*q, message.clear_stop != 0);
  gripper_.Command(message.opening, message.grip);
  return true;
}

Isometry3d ArmDevice::FlangePose() const {
  return layout_.X_WB * layout_.model->FlangePose(servo_.position());
}

void ArmDevice::Update(double dt, World& world) {
  dt_ = dt;
  servo_.Update(dt, force_);
  gripper_.Update(dt, FlangePose() * layout_.X_FG, world);
}

void ArmDevice::Publish(const World& world) {
  arm_state_t state{};
  state.header.utime = bus_.now();
  ToMessage(servo_.position(), &state.num_joints, &state.position);
  ToMessage(servo_.velocity(), &state.num_joints, &state.velocity);
  state.opening = gripper_.opening();
  state.stance = gripper_.stance();
  state.grip = static_cast<int8_t>(gripper_.state(world));
  state.servo = static_cast<int8_t>(servo_.state());
  bus_.Publish("ARM_STATE_" + suffix_, state);
  PublishStop();

  force_ = world.hands().WrenchOn(layout_.gripper).force.norm();
  if (!layout_.X_FS || !params_.has_sensors) return;
  const Wrench reading = Reading(world, FlangePose());
  wrench_t wrench{};
  wrench.header.utime = bus_.now();
  std::copy_n(reading.force.data(), 3, wrench.force);
  std::copy_n(reading.torque.data(), 3, wrench.torque);
  bus_.Publish("WRENCH_" + suffix_, wrench);
}

void ArmDevice::PublishStop() {
  if (servo_.state() != ArmServo::State::kStopped) {
    num_stopped_ = 0;
    return;
  }
  if (num_stopped_ == 0) stop_utime_ = bus_.now();
  if (num_stopped_++ % kStopPeriod != 0) return;
  arm_stop_t stop{};
  stop.header.utime = stop_utime_;
  stop.arm = layout_.name;
  stop.limit = "stop_force_n";
  stop.where = "the gripper of the " + layout_.name + " arm";
  stop.unit = "N";
  stop.measured = servo_.stopped_by();
  stop.allowed = params_.servo.stop_force;
  bus_.Publish("ARM_STOP_" + suffix_, stop);
}

/// What the held part does to the tool, the tool's own weight and inertia, and
/// the bias, in S.
Wrench ArmDevice::Reading(const World& world, const Isometry3d& X_WF) {
  const Wrench on_G = world.hands().WrenchOn(layout_.gripper);
  const Isometry3d X_SG = layout_.X_FS->inverse() * layout_.X_FG;
  Wrench reading = params_.bias;
  const Vector3d f_S = X_SG.linear() * on_G.force;
  reading.force += f_S;
  reading.torque += X_SG.linear() * on_G.torque + X_SG.translation().cross(f_S);

  const Vector3d p_W = X_WF * layout_.p_F_tool;
  const Vector3d acceleration =
      (p_W - 2 * p_W_tool_[0] + p_W_tool_[1]) / (dt_ * dt_);
  p_W_tool_[1] = p_W_tool_[0];
  p_W_tool_[0] = p_W;
  const Isometry3d X_WS = X_WF * *layout_.X_FS;
  const Vector3d weight_S = X_WS.linear().transpose() *
                            (layout_.tool_mass * (kGravity - acceleration));
  const Vector3d p_S = layout_.X_FS->inverse() * layout_.p_F_tool;
  reading.force += weight_S;
  reading.torque += p_S.cross(weight_S);
  return reading;
}

bool ArmDevice::IsAtRest() const {
  return servo_.velocity().cwiseAbs().maxCoeff() < kStill;
}

std::vector<BodyPose> ArmDevice::Bodies() const {
  std::vector<BodyPose> bodies;
  ArmPosture posture = HomePosture(layout_);
  posture.q = servo_.position();
  const std::vector<Isometry3d> X_WB = BodyPosesOf(layout_, posture);
  for (size_t i = 0; i < ArmModel::kNumBodies; ++i) {
    bodies.push_back({body_names_[i], X_WB[i]});
  }
  return bodies;
}

}  // namespace cell::vtb
