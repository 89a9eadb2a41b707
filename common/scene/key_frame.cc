#include "common/scene/key_frame.h"

#include "common/geometry/pose.h"

namespace cell {
namespace {

std::optional<TouchGraph> GraphFromMessage(const key_frame_t& message,
                                           const SceneObjects& scene_objects) {
  const auto& names = scene_objects.names();
  if (message.relations.size() != names.size() * (names.size() - 1) / 2) {
    return std::nullopt;
  }
  TouchGraph graph;
  size_t next = 0;
  for (size_t i = 0; i < names.size(); ++i) {
    for (size_t j = i + 1; j < names.size(); ++j) {
      const relation_t& r = message.relations[next++];
      const auto relation = RelationFromCode(r.relation);
      if (r.first != names[i] || r.second != names[j] || !relation) {
        return std::nullopt;
      }
      graph.emplace_hint(graph.end(), ObjectPair{r.first, r.second}, *relation);
    }
  }
  return graph;
}

}  // namespace

std::optional<KeyFrame> KeyFrameFromMessage(const key_frame_t& message,
                                            const SceneObjects& scene_objects) {
  if (message.index < 0) return std::nullopt;
  auto graph = GraphFromMessage(message, scene_objects);
  if (!graph) return std::nullopt;
  KeyFrame frame{message.header.utime, message.index, *std::move(graph), {}};
  for (const body_pose_t& body : message.poses) {
    const auto X_WO = PoseFromMessage(body.pose_world_body);
    const bool is_next =
        frame.poses.empty() || frame.poses.rbegin()->first < body.name;
    if (!X_WO || !is_next || !scene_objects.IsPart(body.name))
      return std::nullopt;
    frame.poses.emplace_hint(frame.poses.end(), body.name, *X_WO);
  }
  return frame;
}

key_frame_t KeyFrameToMessage(const KeyFrame& frame) {
  key_frame_t message{};
  message.header.utime = frame.utime;
  message.index = frame.index;
  for (const auto& [pair, relation] : frame.relations) {
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
  return message;
}

}  // namespace cell
