#include "common/scene/key_frame.h"

#include <algorithm>
#include <functional>
#include <set>

#include "common/geometry/pose.h"
#include "common/scene/segment_name.h"

namespace cell {
namespace {

/// The scene's objects and the segments that the message names, sorted; nullopt
/// if there are too many.
std::optional<std::vector<std::string>> NamesIn(
    const key_frame_t& message, const SceneObjects& scene_objects) {
  std::set<std::string> segments;
  for (const relation_t& r : message.relations) {
    for (const std::string& name : {r.first, r.second}) {
      if (IsSegmentName(name)) segments.insert(name);
    }
    if (segments.size() > kMaxSegments) return std::nullopt;
  }
  std::vector<std::string> names = scene_objects.names();
  names.insert(names.end(), segments.begin(), segments.end());
  std::ranges::sort(names);
  return names;
}

/// False unless it has all pairs in order.
bool RelationsFromMessage(const key_frame_t& message,
                          const SceneObjects& scene_objects, KeyFrame& frame) {
  const auto names = NamesIn(message, scene_objects);
  if (!names ||
      message.relations.size() != names->size() * (names->size() - 1) / 2) {
    return false;
  }
  size_t next = 0;
  for (size_t i = 0; i < names->size(); ++i) {
    for (size_t j = i + 1; j < names->size(); ++j) {
      const relation_t& r = message.relations[next++];
      const auto relation = RelationFromCode(r.relation);
      if (r.first != (*names)[i] || r.second != (*names)[j] || !relation) {
        return false;
      }
      const ObjectPair pair{r.first, r.second};
      TouchGraph& graph = RelationsWith(pair, &frame);
      graph.emplace_hint(graph.end(), pair, *relation);
    }
  }
  return true;
}

bool TouchIn(const KeyFrame& frame, const ObjectPair& pair) {
  return Touch(frame.relations, pair.first, pair.second) ||
         Touch(frame.segment_relations, pair.first, pair.second);
}

bool HasName(const std::string& channel) {
  constexpr size_t kMaxLength = 63;  // of LCM
  return !channel.empty() && channel.size() <= kMaxLength;
}

// False unless they are of pairs that touch, in order.
bool RelativePosesFromMessage(const key_frame_t& message, KeyFrame& frame) {
  for (const relative_pose_t& relative : message.relative_poses) {
    pose_t pose{};
    std::ranges::copy(relative.position, pose.position);
    std::ranges::copy(relative.quat_wxyz, pose.quat_wxyz);
    const ObjectPair pair(relative.first, relative.second);
    const auto X_AB = PoseFromMessage(pose);
    auto& poses = frame.relative_poses;
    const bool is_next = poses.empty() || poses.rbegin()->first < pair;
    if (!X_AB || !is_next || pair.second <= pair.first ||
        !TouchIn(frame, pair)) {
      return false;
    }
    poses.emplace_hint(poses.end(), pair, *X_AB);
  }
  return true;
}

std::optional<LogSegment> SegmentFromMessage(const log_segment_t& message,
                                             int64_t end_utime) {
  if (message.end_utime != end_utime || message.begin_utime > end_utime ||
      message.begin_utime < 0 ||
      !std::ranges::all_of(message.channels, HasName) ||
      std::ranges::adjacent_find(message.channels, std::greater_equal<>()) !=
          message.channels.end()) {
    return std::nullopt;
  }
  return LogSegment{message.begin_utime, message.channels};
}

relative_pose_t RelativePoseToMessage(const ObjectPair& pair,
                                      const Eigen::Isometry3d& X_AB) {
  relative_pose_t relative{};
  relative.first = pair.first;
  relative.second = pair.second;
  const pose_t pose = PoseToMessage(X_AB);
  std::ranges::copy(pose.position, relative.position);
  std::ranges::copy(pose.quat_wxyz, relative.quat_wxyz);
  return relative;
}

}  // namespace

TouchGraph& RelationsWith(const ObjectPair& pair, KeyFrame* frame) {
  return IsSegmentName(pair.first) || IsSegmentName(pair.second)
             ? frame->segment_relations
             : frame->relations;
}

std::optional<KeyFrame> KeyFrameFromMessage(const key_frame_t& message,
                                            const SceneObjects& scene_objects) {
  if (message.index < 0) return std::nullopt;
  KeyFrame frame{message.header.utime, message.index, {}, {}};
  if (!RelationsFromMessage(message, scene_objects, frame)) return std::nullopt;
  for (const body_pose_t& body : message.poses) {
    const auto X_WO = PoseFromMessage(body.pose_world_body);
    const bool is_next =
        frame.poses.empty() || frame.poses.rbegin()->first < body.name;
    if (!X_WO || !is_next || !scene_objects.IsPart(body.name))
      return std::nullopt;
    frame.poses.emplace_hint(frame.poses.end(), body.name, *X_WO);
  }
  auto segment = SegmentFromMessage(message.segment, frame.utime);
  if (!segment || !RelativePosesFromMessage(message, frame)) {
    return std::nullopt;
  }
  frame.segment = *std::move(segment);
  return frame;
}

key_frame_t KeyFrameToMessage(const KeyFrame& frame) {
  key_frame_t message{};
  message.header.utime = frame.utime;
  message.index = frame.index;
  TouchGraph all = frame.relations;
  all.insert(frame.segment_relations.begin(), frame.segment_relations.end());
  for (const auto& [pair, relation] : all) {
    relation_t& r = message.relations.emplace_back();
    r.first = pair.first;
    r.second = pair.second;
    r.relation = static_cast<int8_t>(relation);
  }
  message.num_relations = static_cast<int32_t>(message.relations.size());
  for (const auto& [name, X_WO] : frame.poses) {
    body_pose_t& body = message.poses.emplace_back();
    body.name = name;
    body.pose_world_body = PoseToMessage(X_WO);
  }
  message.num_poses = static_cast<int32_t>(message.poses.size());
  for (const auto& [pair, X_AB] : frame.relative_poses) {
    message.relative_poses.push_back(RelativePoseToMessage(pair, X_AB));
  }
  message.num_relative_poses =
      static_cast<int32_t>(message.relative_poses.size());
  message.segment.begin_utime = frame.segment.begin_utime;
  message.segment.end_utime = frame.utime;
  message.segment.channels = frame.segment.channels;
  message.segment.num_channels =
      static_cast<int32_t>(frame.segment.channels.size());
  return message;
}

}  // namespace cell
