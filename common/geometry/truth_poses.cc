#include "common/geometry/truth_poses.h"

#include "common/geometry/pose.h"

namespace cell {
namespace {

constexpr size_t kMaxBodies = 10'000;

}  // namespace

std::optional<TruthPoses> TruthFromMessage(const truth_poses_t& message) {
  if (message.bodies.size() > kMaxBodies) return std::nullopt;
  TruthPoses truth{message.header.utime, {}};
  for (const body_pose_t& body : message.bodies) {
    const auto X_WB = PoseFromMessage(body.pose_world_body);
    if (!X_WB || !truth.poses.emplace(body.name, *X_WB).second) {
      return std::nullopt;
    }
  }
  return truth;
}

}  // namespace cell
