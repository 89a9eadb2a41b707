#include "services/sec_builder/layer_sensor.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/part_shape.h"

namespace cell::sec_builder {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

AlignedBox3d BoxInWorld(const AlignedBox3d& box_O,
                        const Eigen::Isometry3d& X_WO) {
  AlignedBox3d box_W;
  for (int corner = 0; corner < 8; ++corner) {
    box_W.extend(X_WO *
                 box_O.corner(static_cast<AlignedBox3d::CornerType>(corner)));
  }
  return box_W;
}

double MiddleZ(const AlignedBox3d& box) {
  return box.center().z();
}

bool IsAbove(const AlignedBox3d& a, const AlignedBox3d& b) {
  return a.min().z() > MiddleZ(b) &&
         (a.min().head<2>().array() <= b.max().head<2>().array()).all() &&
         (b.min().head<2>().array() <= a.max().head<2>().array()).all();
}

}  // namespace

LayerSensor::Params LayerSensor::Params::FromConfig(const Config& config) {
  Params params;
  params.has_places = config.Get<bool>("static_relations");
  params.has_motions = config.Get<bool>("dynamic_relations");
  return params;
}

LayerSensor::LayerSensor(const SceneObjects& scene_objects,
                         const PartTable& parts, const Params& params)
    : scene_objects_(scene_objects), params_(params) {
  if (!params.is_on()) return;
  for (const Part& part : parts.parts()) {
    boxes_.emplace(part.name, PartShape(part).box());
  }
}

void LayerSensor::Update(const Tracks& tracks) {
  if (!params_.is_on()) return;
  Moment moment{tracks.utime, {}};
  for (const Track& track : tracks.tracks) {
    if (track.state == Track::State::kLost) continue;
    const auto box = boxes_.find(track.name);
    if (box != boxes_.end()) {
      moment.extents[track.name] = BoxInWorld(box->second, track.X_WO);
    } else if (!track.points.empty()) {
      AlignedBox3d& extent = moment.extents[track.name];
      for (const Vector3d& point : track.points) extent.extend(point);
    }
  }
  moments_.push_back(std::move(moment));
  while (moments_.front().utime < tracks.utime - kMemoryUs) {
    moments_.pop_front();
  }
}

RelationLayers LayerSensor::Sense(const KeyFrame& frame) {
  RelationLayers layers{frame.index, {}, {}};
  const Extents& now = ExtentsAt(frame.utime);
  for (const auto& [pair, relation] : frame.relations) {
    const auto& [a, b] = pair;
    Place place = params_.has_places ? PlaceOf(a, b, now) : Place::kNone;
    if (Touch(frame.relations, a, b)) {
      if (place == Place::kAbove) place = Place::kOn;
      if (place == Place::kBelow) place = Place::kCarries;
    }
    if (place != Place::kNone) layers.places.emplace(pair, place);
    const Motion motion =
        params_.has_motions ? MotionOf(a, b, now) : Motion::kNone;
    if (motion != Motion::kNone) layers.motions.emplace(pair, motion);
  }
  before_ = now;
  return layers;
}

// The last that is not later; of an earlier time the first.
const LayerSensor::Extents& LayerSensor::ExtentsAt(int64_t utime) const {
  static const Extents kNothing;
  if (moments_.empty()) return kNothing;
  const auto next =
      std::ranges::upper_bound(moments_, utime, {}, &Moment::utime);
  return next == moments_.begin() ? next->extents : std::prev(next)->extents;
}

Place LayerSensor::PlaceOf(const std::string& a, const std::string& b,
                           const Extents& now) const {
  if (a == SceneObjects::kTable || b == SceneObjects::kTable) {
    const bool is_there = now.contains(a == SceneObjects::kTable ? b : a);
    if (!is_there) return Place::kNone;
    return a == SceneObjects::kTable ? Place::kBelow : Place::kAbove;
  }
  const auto box_a = now.find(a), box_b = now.find(b);
  if (box_a == now.end() || box_b == now.end()) return Place::kNone;
  if (IsInside(box_a->second, box_b->second)) return Place::kInside;
  if (IsInside(box_b->second, box_a->second)) return Place::kHolds;
  if (IsAbove(box_a->second, box_b->second)) return Place::kAbove;
  if (IsAbove(box_b->second, box_a->second)) return Place::kBelow;
  return Place::kNone;
}

Motion LayerSensor::MotionOf(const std::string& a, const std::string& b,
                             const Extents& now) const {
  const auto is_table = [](const std::string& name) {
    return name == SceneObjects::kTable;
  };
  const auto is_known = [&](const std::string& name) {
    return is_table(name) || (now.contains(name) && before_.contains(name));
  };
  if (!is_known(a) || !is_known(b)) return Motion::kNone;
  double closer = 0;  // [m]
  if (is_table(a) || is_table(b)) {
    const std::string& other = is_table(a) ? b : a;
    closer = before_.at(other).min().z() - now.at(other).min().z();
  } else {
    const Vector3d from_a = before_.at(a).center(), to_a = now.at(a).center();
    const Vector3d from_b = before_.at(b).center(), to_b = now.at(b).center();
    const Vector3d u = to_a - from_a, v = to_b - from_b;
    if (u.norm() > params_.motion && v.norm() > params_.motion &&
        (u - v).norm() < params_.motion) {
      return Motion::kMovingTogether;
    }
    closer = (from_a - from_b).norm() - (to_a - to_b).norm();
  }
  if (std::abs(closer) <= params_.motion) return Motion::kNone;
  return closer > 0 ? Motion::kGettingCloser : Motion::kMovingApart;
}

bool LayerSensor::IsInside(const AlignedBox3d& a, const AlignedBox3d& b) const {
  const double margin = params_.outline;
  return (a.min().head<2>().array() >= b.min().head<2>().array() - margin)
             .all() &&
         (a.max().head<2>().array() <= b.max().head<2>().array() + margin)
             .all() &&
         a.min().z() < MiddleZ(b) && a.max().z() > MiddleZ(b);
}

}  // namespace cell::sec_builder
