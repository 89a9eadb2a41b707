#include "common/scene/track.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/pose.h"

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

std::optional<Track> TrackFromMessage(const track_t& message,
                                      const SceneObjects& scene_objects) {
  const bool is_hand = message.kind == track_t::HAND;
  if (!is_hand && message.kind != track_t::PART) return std::nullopt;
  if (is_hand ? !scene_objects.IsHand(message.name)
              : !scene_objects.IsPart(message.name)) {
    return std::nullopt;
  }
  if (message.state < track_t::TRACKED || message.state > track_t::LOST ||
      !(message.confidence >= 0 && message.confidence <= 1)) {
    return std::nullopt;
  }
  const auto X_WO = PoseFromMessage(message.pose_world_object);
  if (!X_WO || (!is_hand && !message.points.empty())) return std::nullopt;
  Track track{message.name,
              static_cast<Track::State>(message.state),
              message.confidence,
              *X_WO,
              {}};
  if (!PointsFromMessage(message, track.points)) return std::nullopt;
  return track;
}

}  // namespace

const Track* Tracks::Find(const std::string& name) const {
  const auto it =
      std::lower_bound(tracks.begin(), tracks.end(), name,
                       [](const Track& track, const std::string& wanted) {
                         return track.name < wanted;
                       });
  return it != tracks.end() && it->name == name ? &*it : nullptr;
}

std::optional<Tracks> TracksFromMessage(const tracks_t& message,
                                        const SceneObjects& scene_objects) {
  if (message.tracks.size() > scene_objects.names().size()) return std::nullopt;
  Tracks tracks{message.header.utime, {}};
  for (const track_t& track_message : message.tracks) {
    auto track = TrackFromMessage(track_message, scene_objects);
    if (!track) return std::nullopt;
    if (!tracks.tracks.empty() && tracks.tracks.back().name >= track->name) {
      return std::nullopt;
    }
    tracks.tracks.push_back(*std::move(track));
  }
  return tracks;
}

tracks_t TracksToMessage(const Tracks& tracks,
                         const SceneObjects& scene_objects) {
  tracks_t message{};
  message.header.utime = tracks.utime;
  message.num_tracks = static_cast<int32_t>(tracks.tracks.size());
  for (const Track& track : tracks.tracks) {
    track_t& t = message.tracks.emplace_back();
    t.name = track.name;
    t.kind = scene_objects.IsHand(track.name) ? track_t::HAND : track_t::PART;
    t.state = static_cast<int8_t>(track.state);
    t.confidence = track.confidence;
    t.pose_world_object = PoseToMessage(track.X_WO);
    t.num_points = static_cast<int32_t>(track.points.size());
    t.points.resize(track.points.size());
    for (size_t i = 0; i < track.points.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        t.points[i].xyz[axis] = static_cast<float>(track.points[i][axis]);
      }
    }
  }
  return message;
}

}  // namespace cell
