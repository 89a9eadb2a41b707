#include "common/scene/track.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/pose.h"
#include "common/scene/segment_name.h"

namespace cell {
namespace {

constexpr size_t kMaxPoints = 20'000;
constexpr float kMaxDistance = 100;  // [m]

bool PointsFromMessage(const track_t& message,
                       std::vector<Eigen::Vector3d>& points) {
  if (message.points.size() > kMaxPoints) return false;
  points.reserve(message.points.size());
  for (const point_t& point : message.points) {
    for (const float value : point.xyz) {
      if (!(std::abs(value) <= kMaxDistance)) return false;
    }
    points.emplace_back(point.xyz[0], point.xyz[1], point.xyz[2]);
  }
  return true;
}

bool IsKindOf(const track_t& message, const SceneObjects& scene_objects) {
  if (scene_objects.IsPart(message.name)) return message.kind == track_t::PART;
  if (scene_objects.IsHand(message.name)) return message.kind == track_t::HAND;
  return !scene_objects.Has(message.name) && message.kind >= track_t::PART &&
         message.kind <= track_t::SEGMENT;
}

std::optional<Track> TrackFromMessage(const track_t& message,
                                      const SceneObjects& scene_objects) {
  const bool is_part = scene_objects.IsPart(message.name);
  if (!IsKindOf(message, scene_objects)) return std::nullopt;
  if (message.state < track_t::TRACKED || message.state > track_t::LOST ||
      !(message.confidence >= 0 && message.confidence <= 1)) {
    return std::nullopt;
  }
  const auto X_WO = PoseFromMessage(message.pose_world_object);
  if (!X_WO || (is_part && !message.points.empty())) return std::nullopt;
  Track track{message.name,
              static_cast<Track::State>(message.state),
              message.confidence,
              *X_WO,
              {}};
  if (!PointsFromMessage(message, track.points)) return std::nullopt;
  return track;
}

track_t TrackToMessage(const Track& track, const SceneObjects& scene_objects) {
  track_t message{};
  message.name = track.name;
  message.kind = scene_objects.IsPart(track.name)   ? track_t::PART
                 : scene_objects.IsHand(track.name) ? track_t::HAND
                                                    : track_t::SEGMENT;
  message.state = static_cast<int8_t>(track.state);
  message.confidence = track.confidence;
  message.pose_world_object = PoseToMessage(track.X_WO);
  message.num_points = static_cast<int32_t>(track.points.size());
  message.points.resize(track.points.size());
  for (size_t i = 0; i < track.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      message.points[i].xyz[axis] = static_cast<float>(track.points[i][axis]);
    }
  }
  return message;
}

}  // namespace

const Track* Tracks::Find(const std::string& name) const {
  const std::vector<Track>& among = IsSegmentName(name) ? segments : tracks;
  const auto it = std::ranges::lower_bound(among, name, {}, &Track::name);
  return it != among.end() && it->name == name ? &*it : nullptr;
}

std::optional<Tracks> TracksFromMessage(const tracks_t& message,
                                        const SceneObjects& scene_objects) {
  if (message.tracks.size() > scene_objects.names().size() + kMaxSegments) {
    return std::nullopt;
  }
  Tracks tracks{message.header.utime, {}};
  const std::string* last = nullptr;
  for (const track_t& track_message : message.tracks) {
    if (last != nullptr && *last >= track_message.name) return std::nullopt;
    last = &track_message.name;
    auto track = TrackFromMessage(track_message, scene_objects);
    if (!track) return std::nullopt;
    if (scene_objects.Has(track->name)) {
      tracks.tracks.push_back(*std::move(track));
      continue;
    }
    const auto name = SegmentName(track->name);
    if (!name) return std::nullopt;
    if (track->points.empty()) {
      tracks.left_out.push_back(track->name);
      continue;
    }
    track->name = *name;
    tracks.segments.push_back(*std::move(track));
  }
  std::ranges::sort(tracks.segments, {}, &Track::name);
  const auto duplicate =
      std::ranges::adjacent_find(tracks.segments, {}, &Track::name);
  if (duplicate != tracks.segments.end()) return std::nullopt;
  return tracks;
}

tracks_t TracksToMessage(const Tracks& tracks,
                         const SceneObjects& scene_objects) {
  tracks_t message{};
  message.header.utime = tracks.utime;
  for (const std::vector<Track>* some : {&tracks.tracks, &tracks.segments}) {
    for (const Track& track : *some) {
      message.tracks.push_back(TrackToMessage(track, scene_objects));
    }
  }
  std::ranges::sort(message.tracks, {}, &track_t::name);
  message.num_tracks = static_cast<int32_t>(message.tracks.size());
  return message;
}

}  // namespace cell
