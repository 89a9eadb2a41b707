#include "services/sec_builder/proximity.h"

#include <algorithm>
#include <utility>

namespace cell::sec_builder {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::vector<Vector3d> PointsWithin(const PointCloud& cloud,
                                   const PointCloud& other, double margin) {
  AlignedBox3d box;
  for (const Vector3d& point : other.points()) box.extend(point);
  std::vector<Vector3d> points;
  for (const Vector3d& point : cloud.points()) {
    if (box.exteriorDistance(point) < margin) points.push_back(point);
  }
  return points;
}

}  // namespace

ProximitySensor::ProximitySensor(const SceneObjects& scene_objects,
                                 const PartTable& parts, const Params& params)
    : scene_objects_(scene_objects), params_(params) {
  for (const Part& part : parts.parts()) {
    shapes_.emplace(part.name, PartShape(part));
  }
}

Proximities ProximitySensor::Measure(const Tracks& tracks) const {
  std::vector<std::pair<std::string, Posed>> objects;
  for (const std::string& name : scene_objects_.names()) {
    const Track* track = tracks.Find(name);
    if (name == SceneObjects::kTable) {
      objects.emplace_back(name, Posed{});
    } else if (track && track->state == Track::State::kTracked) {
      Posed& posed = objects.emplace_back(name, Posed{track}).second;
      if (scene_objects_.IsPart(name)) {
        posed.shape = &shapes_.at(name);
      } else {
        posed.cloud = PointCloud(track->points);
      }
    }
  }
  for (const Track& segment : tracks.segments) {
    if (segment.state != Track::State::kTracked) continue;
    Posed& posed = objects.emplace_back(segment.name, Posed{&segment}).second;
    posed.cloud = PointCloud(segment.points);
  }
  std::ranges::sort(objects, {}, [](const auto& object) -> const std::string& {
    return object.first;
  });
  Proximities proximities;
  for (size_t i = 0; i < objects.size(); ++i) {
    for (size_t j = i + 1; j < objects.size(); ++j) {
      proximities.emplace_hint(proximities.end(),
                               ObjectPair{objects[i].first, objects[j].first},
                               Between(objects[i].second, objects[j].second));
    }
  }
  return proximities;
}

Proximity ProximitySensor::Between(const Posed& a, const Posed& b) const {
  if (!a.track) return {FromTable(b)};
  if (!b.track) return {FromTable(a)};
  if (a.shape && b.shape) return OfParts(a, b);
  if (!a.shape && !b.shape) return {OfClouds(a.cloud, b.cloud)};
  const Posed& part = a.shape ? a : b;
  const Posed& other = a.shape ? b : a;
  return {part.shape->DistanceTo(other.cloud, part.track->X_WO, params_.cutoff,
                                 params_.enough)};
}

// Containment is asked only of the one that could be inside the other.
Proximity ProximitySensor::OfParts(const Posed& a, const Posed& b) const {
  Proximity proximity;
  proximity.distance =
      PartShape::Distance(*a.shape, a.track->X_WO, *b.shape, b.track->X_WO,
                          params_.cutoff, params_.enough);
  if (proximity.distance >= params_.cutoff) return proximity;
  const bool a_is_larger = a.shape->box().volume() >= b.shape->box().volume();
  const Posed& outer = a_is_larger ? a : b;
  const Posed& inner = a_is_larger ? b : a;
  proximity.slack =
      outer.shape->Slack(outer.track->X_WO, *inner.shape, inner.track->X_WO);
  return proximity;
}

double ProximitySensor::FromTable(const Posed& object) const {
  double lowest = params_.cutoff;
  if (object.shape) lowest = object.shape->LowestZ(object.track->X_WO);
  for (const Vector3d& point : object.cloud.points()) {
    lowest = std::min(lowest, point.z());
  }
  return std::clamp(lowest, 0.0, params_.cutoff);
}

double ProximitySensor::OfClouds(const PointCloud& a,
                                 const PointCloud& b) const {
  const double between = (a.centre() - b.centre()).norm();
  double nearest = params_.cutoff;
  if (between - a.radius() - b.radius() >= nearest) return nearest;
  const std::vector<Vector3d> of_b = PointsWithin(b, a, nearest);
  for (const Vector3d& p : PointsWithin(a, b, nearest)) {
    for (const Vector3d& q : of_b) {
      if ((p - q).squaredNorm() < nearest * nearest) nearest = (p - q).norm();
    }
  }
  return nearest;
}

}  // namespace cell::sec_builder
