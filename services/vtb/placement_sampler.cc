#include "services/vtb/placement_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Outline = std::vector<Vector2d>;

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Andrew's monotone chain, counter-clockwise.
Outline ConvexHull(Outline points) {
  std::ranges::sort(points, [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Outline hull;
  const auto add = [&](const Vector2d& p, size_t floor) {
    while (hull.size() >= floor + 2 &&
           Cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vector2d& p : points) add(p, 0);
  const size_t lower = hull.size() - 1;
  for (size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

double PointToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const double s = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - s * ab).norm();
}

bool Separates(const Vector2d& p, const Vector2d& q, const Outline& other) {
  return std::ranges::all_of(
      other, [&](const Vector2d& r) { return Cross(q - p, r - p) < 0; });
}

template <class Visit>
void ForEachEdge(const Outline& outline, Visit visit) {
  for (size_t i = 0; i < outline.size(); ++i) {
    visit(outline[i], outline[(i + 1) % outline.size()]);
  }
}

// The scene with a part where it is to lie.
std::vector<PlacementSampler::Placed> With(
    std::vector<PlacementSampler::Placed> scene,
    const PlacementSampler::Placed& placed) {
  std::erase_if(scene,
                [&](const auto& other) { return other.part == placed.part; });
  scene.push_back(placed);
  return scene;
}

}  // namespace

double DistanceBetween(const Outline& a, const Outline& b) {
  bool is_apart = false;
  double distance = std::numeric_limits<double>::infinity();
  const auto measure = [&](const Outline& edges, const Outline& points) {
    ForEachEdge(edges, [&](const Vector2d& p, const Vector2d& q) {
      is_apart = is_apart || Separates(p, q, points);
      for (const Vector2d& r : points) {
        distance = std::min(distance, PointToSegment(r, p, q));
      }
    });
  };
  measure(a, b);
  measure(b, a);
  return is_apart ? distance : 0;
}

PartExtent::PartExtent(const Part& part) {
  Outline points;
  for (const Piece& piece : part.pieces) {
    if (!piece.is_shape) continue;
    for (const Vector3d& vertex : AsHull(piece).vertices) {
      vertices.push_back(vertex);
      points.emplace_back(vertex.head<2>());
      radius = std::max(radius, vertex.norm());
    }
  }
  footprint = ConvexHull(points);
}

double PartExtent::Lowest(const Isometry3d& X_WO) const {
  double z = std::numeric_limits<double>::infinity();
  for (const Vector3d& p : vertices) z = std::min(z, (X_WO * p).z());
  return z;
}

double PartExtent::Highest(const Isometry3d& X_WO) const {
  double z = -std::numeric_limits<double>::infinity();
  for (const Vector3d& p : vertices) z = std::max(z, (X_WO * p).z());
  return z;
}

double PartExtent::RadiusAcross(const Isometry3d& X_WO) const {
  double r = 0;
  for (const Vector3d& p : vertices) {
    r = std::max(r, (X_WO.linear() * p).head<2>().norm());
  }
  return r;
}

PlacementSampler::PlacementSampler(const PartTable& table,
                                   const CellLayout& layout, double gap)
    : area_(layout.parts_area), gap_(gap) {
  for (const Part& part : table.parts()) {
    extents_.emplace(part.name, PartExtent(part));
    if (part.is_free()) free_parts_.push_back(part.name);
  }
  std::ranges::stable_sort(
      free_parts_, std::ranges::greater{},
      [&](const std::string& name) { return extents_.at(name).radius; });
}

Outline PlacementSampler::OutlineAt(const Placed& placed) const {
  // Upright or not, the hull of what is seen from above.
  Outline points;
  for (const Vector3d& p : extents_.at(placed.part).vertices) {
    points.emplace_back((placed.X_WO * p).head<2>());
  }
  return ConvexHull(points);
}

bool PlacementSampler::Starts::Has(const std::string& part) const {
  return lying.contains(part) ||
         std::ranges::find(placed, part, &Placed::part) != placed.end();
}

std::optional<PlacementSampler::Placed> PlacementSampler::TryPlace(
    const std::string& part, const Matrix3d* R_WO,
    const std::vector<Outline>& taken, std::mt19937_64& random) const {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  const PartExtent& extent = extents_.at(part);
  Isometry3d X_WO = Isometry3d::Identity();
  X_WO.translation().x() = area_.centre.x() + unit(random) * area_.size.x();
  X_WO.translation().y() = area_.centre.y() + unit(random) * area_.size.y();
  X_WO.linear() =
      Eigen::AngleAxisd(2 * std::numbers::pi * unit(random), Vector3d::UnitZ())
          .toRotationMatrix();
  if (R_WO != nullptr) X_WO.linear() = X_WO.linear() * *R_WO;
  X_WO.translation().z() = -extent.Lowest(X_WO);
  Outline outline;
  if (R_WO != nullptr) outline = OutlineAt({part, X_WO});
  for (const Vector2d& p : extent.footprint) {
    if (R_WO != nullptr) break;
    outline.emplace_back((X_WO * Vector3d(p.x(), p.y(), 0)).head<2>());
  }
  for (const Vector2d& p : outline) {
    const Vector2d off = (p - area_.centre).cwiseAbs();
    if (off.x() > area_.size.x() / 2 || off.y() > area_.size.y() / 2) {
      return std::nullopt;
    }
  }
  for (const Outline& other : taken) {
    if (DistanceBetween(outline, other) < gap_) return std::nullopt;
  }
  return Placed{part, X_WO};
}

std::vector<PlacementSampler::Placed> PlacementSampler::Scatter(
    const Starts& starts, std::mt19937_64& random, const Accept& accept) const {
  constexpr int kAttempts = 1000, kTriesPerPart = 300;
  const Matrix3d tipped =
      Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX())
          .toRotationMatrix();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<Placed> scene = starts.placed;
    std::vector<Outline> taken;
    for (const Placed& placed : scene) taken.push_back(OutlineAt(placed));
    for (const std::string& part : free_parts_) {
      if (starts.Has(part) && !starts.lying.contains(part)) continue;
      const Matrix3d* R_WO = starts.lying.contains(part) ? &tipped : nullptr;
      std::optional<Placed> placed;
      for (int i = 0; i < kTriesPerPart && !placed; ++i) {
        placed = TryPlace(part, R_WO, taken, random);
      }
      if (!placed) break;
      taken.push_back(OutlineAt(*placed));
      scene.push_back(*placed);
    }
    if (scene.size() < free_parts_.size()) continue;
    if (!accept || accept(scene)) return scene;
  }
  throw std::runtime_error(
      "the parts do not fit into the parts area with room to grasp each");
}

std::optional<Isometry3d> PlacementSampler::FreePlace(
    const std::string& part, const std::vector<Placed>& scene, double min_way,
    std::mt19937_64& random, const Accept& accept) const {
  std::vector<Outline> taken;
  Vector3d here = Vector3d::Zero();
  for (const Placed& placed : scene) {
    if (placed.part == part) {
      here = placed.X_WO.translation();
    } else {
      taken.push_back(OutlineAt(placed));
    }
  }
  for (int i = 0; i < 1000; ++i) {
    const std::optional<Placed> found = TryPlace(part, nullptr, taken, random);
    if (!found) continue;
    const Vector3d way = found->X_WO.translation() - here;
    if (way.head<2>().norm() < min_way) continue;
    if (!accept || accept(With(scene, *found))) return found->X_WO;
  }
  return std::nullopt;
}

}  // namespace cell::vtb
