#include "common/arms/motion_messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/pose.h"
#include "common/kinematics/joint_values.h"

namespace cell {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMaxLength = 10;  // [m]
constexpr double kMaxSide = 2;     // [m] of an area that is searched
constexpr double kMaxTurn = 100;   // [rad]
constexpr double kUnit = 1e-4;     // by which a direction's length may be off
constexpr size_t kMaxWaypoints = 10'000;

bool IsLength(double value) {
  return value >= 0 && value <= kMaxLength;
}

place_target_t ToMessage(const PlaceTarget& target) {
  place_target_t message{};
  message.pose_world_object = PoseToMessage(target.X_WO);
  std::copy_n(target.way_out.data(), 3, message.way_out);
  message.approach = target.approach;
  message.turn = target.turn;
  return message;
}

std::optional<PlaceTarget> FromMessage(const place_target_t& message) {
  const auto X_WO = PoseFromMessage(message.pose_world_object);
  const Vector3d way_out(message.way_out);
  if (!X_WO || !(std::abs(way_out.norm() - 1) < kUnit) ||
      !IsLength(message.approach) || !(std::abs(message.turn) < kMaxTurn)) {
    return std::nullopt;
  }
  return PlaceTarget{*X_WO, way_out.normalized(), message.approach,
                     message.turn};
}

arm_posture_t ToMessage(const std::string& name,
                        const MotionRequest::Arm& arm) {
  arm_posture_t message{};
  message.arm = name;
  cell::ToMessage(arm.posture.q, &message.num_joints, &message.position);
  message.opening = arm.posture.opening;
  message.grip = arm.posture.grip;
  if (arm.held) message.held = arm.held->part;
  message.pose_gripper_held =
      PoseToMessage(arm.held ? arm.held->X_GO : Eigen::Isometry3d::Identity());
  return message;
}

Result<MotionRequest::Arm> FromMessage(const arm_posture_t& message,
                                       const PartTable& parts,
                                       const CellLayout& layout) {
  const ArmLayout* arm = layout.FindArm(message.arm);
  if (arm == nullptr) return Reason{"there is no arm " + message.arm};
  if (arm->hand.FindGrip(message.grip) == nullptr ||
      !IsLength(message.opening)) {
    return Reason{message.arm + ": an impossible grip or opening"};
  }
  const auto q = AnglesFromMessage(message.position, *arm->model);
  if (!q) return Reason{message.arm + ": " + q.reason()};
  const auto X_GO = PoseFromMessage(message.pose_gripper_held);
  if (!X_GO) return Reason{message.arm + ": the held part has no pose"};
  MotionRequest::Arm known{{*q, message.grip, message.opening}, std::nullopt};
  if (message.held.empty()) return known;
  const Part* part = parts.Find(message.held);
  if (part == nullptr || part->is_fixed) {
    return Reason{message.arm + " cannot hold " + message.held};
  }
  known.held = ArmScene::Held{message.held, *X_GO};
  return known;
}

// Why not; nothing if it could be read.
std::optional<Reason> ReadScene(const motion_request_t& message,
                                const PartTable& parts,
                                const CellLayout& layout,
                                MotionRequest* request) {
  if (message.arms.size() > layout.arms.size() ||
      message.parts.size() > parts.parts().size()) {
    return Reason{"more arms or parts than the cell has"};
  }
  for (const arm_posture_t& entry : message.arms) {
    auto arm = FromMessage(entry, parts, layout);
    if (!arm) return Reason{arm.reason()};
    if (!request->arms.emplace(entry.arm, *std::move(arm)).second) {
      return Reason{entry.arm + " is listed twice"};
    }
  }
  for (const body_pose_t& entry : message.parts) {
    const auto X_WO = PoseFromMessage(entry.pose_world_body);
    if (!X_WO || parts.Find(entry.name) == nullptr ||
        !request->parts.emplace(entry.name, *X_WO).second) {
      return Reason{"part '" + entry.name +
                    "' is not known, is listed twice or has no pose"};
    }
  }
  if (request->arms.contains(request->arm)) return std::nullopt;
  return Reason{"it lacks the state of " + request->arm};
}

/// What its kind needs is there.
bool IsWhole(const MotionRequest& request, const PartTable& parts) {
  using Kind = MotionRequest::Kind;
  const bool is_held = request.arms.at(request.arm).held.has_value();
  const auto can_be_taken = [&](const std::string& name) {
    const Part* part = parts.Find(name);
    return part != nullptr && !part->is_fixed && request.parts.contains(name);
  };
  switch (request.kind) {
    case Kind::kGrasp:
      return can_be_taken(request.part);
    case Kind::kReach:
      return request.wanted.size() <= parts.parts().size() &&
             std::ranges::all_of(request.wanted, can_be_taken);
    case Kind::kPlace:
      return is_held && request.target;
    case Kind::kSetDown:
      return is_held && !request.area.isEmpty() &&
             request.area.sizes().maxCoeff() <= kMaxSide;
    case Kind::kWay:
      return true;
  }
  return false;
}

}  // namespace

motion_request_t ToMessage(const MotionRequest& request) {
  motion_request_t message{};
  message.id = request.id;
  message.arm = request.arm;
  message.kind = static_cast<int8_t>(request.kind);
  for (const auto& [name, arm] : request.arms) {
    message.arms.push_back(ToMessage(name, arm));
  }
  message.num_arms = static_cast<int32_t>(message.arms.size());
  for (const auto& [name, X_WO] : request.parts) {
    message.parts.push_back({name, PoseToMessage(X_WO)});
  }
  message.num_parts = static_cast<int32_t>(message.parts.size());
  message.part = request.part;
  message.wanted = request.wanted;
  message.num_wanted = static_cast<int32_t>(message.wanted.size());
  if (request.target) message.targets.push_back(ToMessage(*request.target));
  message.num_targets = static_cast<int32_t>(message.targets.size());
  std::copy_n(request.area.min().data(), 2, message.area_min);
  std::copy_n(request.area.max().data(), 2, message.area_max);
  message.is_for_other_arm = request.is_for_other_arm;
  ToMessage(request.goal, &message.num_joints, &message.goal);
  return message;
}

Result<MotionRequest> FromMessage(const motion_request_t& message,
                                  const PartTable& parts,
                                  const CellLayout& layout) {
  const ArmLayout* arm = layout.FindArm(message.arm);
  if (arm == nullptr) return Reason{"there is no arm " + message.arm};
  if (message.kind < motion_request_t::GRASP ||
      message.kind > motion_request_t::REACH || message.targets.size() > 1) {
    return Reason{"an unknown kind, or more than one target"};
  }
  MotionRequest request;
  request.id = message.id;
  request.arm = message.arm;
  request.kind = static_cast<MotionRequest::Kind>(message.kind);
  request.part = message.part;
  request.wanted = message.wanted;
  request.is_for_other_arm = message.is_for_other_arm;
  request.area = {Vector2d(message.area_min), Vector2d(message.area_max)};
  const auto goal = AnglesFromMessage(message.goal, *arm->model);
  if (!goal) return Reason{"its goal: " + goal.reason()};
  const auto is_near = [](double value) {
    return std::abs(value) <= kMaxLength;
  };
  if (!std::ranges::all_of(message.area_min, is_near) ||
      !std::ranges::all_of(message.area_max, is_near)) {
    return Reason{"an area that is too far away"};
  }
  request.goal = *goal;
  if (!message.targets.empty()) {
    request.target = FromMessage(message.targets.front());
    if (!request.target) return Reason{"an impossible target"};
  }
  if (auto why = ReadScene(message, parts, layout, &request)) {
    return *std::move(why);
  }
  if (!IsWhole(request, parts))
    return Reason{"a field that its kind needs is missing"};
  return request;
}

motion_plan_t ToMessage(const MotionPlan& plan, int64_t utime) {
  motion_plan_t message{};
  message.header.utime = utime;
  message.id = plan.id;
  message.arm = plan.arm;
  message.is_found = bool(plan);
  message.reason = plan.reason;
  for (const Joints& q : plan.waypoints) {
    waypoint_t& waypoint = message.waypoints.emplace_back();
    ToMessage(q, &waypoint.num_joints, &waypoint.position);
  }
  message.num_waypoints = static_cast<int32_t>(message.waypoints.size());
  message.reachable = plan.reachable;
  message.num_reachable = static_cast<int32_t>(message.reachable.size());
  message.grip = plan.grasp.grip;
  message.opening = plan.grasp.opening;
  message.width = plan.grasp.width;
  message.pose_object_gripper = PoseToMessage(plan.grasp.X_OG);
  message.target = ToMessage(plan.target);
  message.pose_world_object = PoseToMessage(plan.X_WO);
  return message;
}

Result<MotionPlan> FromMessage(const motion_plan_t& message,
                               const CellLayout& layout) {
  const ArmLayout* arm = layout.FindArm(message.arm);
  if (arm == nullptr) return Reason{"there is no arm " + message.arm};
  if (message.is_found != message.reason.empty() ||
      message.waypoints.size() > kMaxWaypoints) {
    return Reason{"neither a path nor a reason why there is none"};
  }
  if (!IsLength(message.opening) || !IsLength(message.width) ||
      (!message.grip.empty() && arm->hand.FindGrip(message.grip) == nullptr)) {
    return Reason{"a grip that " + message.arm + " does not have"};
  }
  const auto X_OG = PoseFromMessage(message.pose_object_gripper);
  const auto target = FromMessage(message.target);
  const auto X_WO = PoseFromMessage(message.pose_world_object);
  if (!X_OG || !target || !X_WO) return Reason{"an impossible pose"};
  MotionPlan plan;
  plan.id = message.id;
  plan.arm = message.arm;
  plan.reason = message.reason;
  for (const waypoint_t& waypoint : message.waypoints) {
    const auto q = AnglesFromMessage(waypoint.position, *arm->model);
    if (!q) return Reason{"a waypoint: " + q.reason()};
    plan.waypoints.push_back(*q);
  }
  plan.reachable = message.reachable;
  plan.grasp.grip = message.grip;
  plan.grasp.opening = message.opening;
  plan.grasp.width = message.width;
  plan.grasp.X_OG = *X_OG;
  if (!plan.waypoints.empty()) plan.grasp.q_approach = plan.waypoints.back();
  plan.target = *target;
  plan.X_WO = *X_WO;
  return plan;
}

}  // namespace cell
