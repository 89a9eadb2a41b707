#include "common/geometry/part_shape.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/distance.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace cell {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Geometry = std::shared_ptr<const fcl::CollisionGeometryd>;

// Two solids and a lower bound of their distance.
using Candidate = std::tuple<double, size_t, size_t>;

Geometry MakeHull(const Piece& piece) {
  auto vertices = std::make_shared<std::vector<Vector3d>>(piece.vertices);
  auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : piece.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_shared<fcl::Convexd>(std::move(vertices),
                                        static_cast<int>(piece.faces.size()),
                                        std::move(faces));
}

Geometry MakeGeometry(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::kBox:
      return std::make_shared<fcl::Boxd>(2 * piece.half_extents);
    case Piece::Kind::kCylinder:
      return std::make_shared<fcl::Cylinderd>(piece.radius,
                                              2 * piece.half_length);
    case Piece::Kind::kHull:
      return MakeHull(piece);
  }
  return nullptr;
}

// Penetration depth is not computed: it is costly and not needed.
double ConvexDistance(const Geometry& a, const Isometry3d& X_WA,
                      const Geometry& b, const Isometry3d& X_WB) {
  fcl::DistanceRequestd request;
  request.enable_signed_distance = false;
  request.distance_tolerance = 1e-10;  // round solids: within 2 um of exact
  fcl::DistanceResultd result;
  fcl::distance(a.get(), X_WA, b.get(), X_WB, request, result);
  return std::max(result.min_distance, 0.0);
}

double LowerBound(const ConvexSolid& a, const ConvexSolid& b,
                  const Vector3d& centre_b_A, const Vector3d& centre_a_B) {
  return std::max(a.box().exteriorDistance(centre_b_A) - b.radius(),
                  b.box().exteriorDistance(centre_a_B) - a.radius());
}

std::vector<Candidate> NearPairs(const PartShape& a, const PartShape& b,
                                 const Isometry3d& X_AB, double cutoff) {
  std::vector<Candidate> candidates;
  const Isometry3d X_BA = X_AB.inverse();
  for (size_t j = 0; j < b.solids().size(); ++j) {
    const ConvexSolid& solid_b = b.solids()[j];
    const Vector3d centre_b_A = X_AB * solid_b.centre();
    if (a.box().exteriorDistance(centre_b_A) - solid_b.radius() >= cutoff) {
      continue;
    }
    for (size_t i = 0; i < a.solids().size(); ++i) {
      const ConvexSolid& solid_a = a.solids()[i];
      const double bound =
          LowerBound(solid_a, solid_b, centre_b_A, X_BA * solid_a.centre());
      if (bound < cutoff) candidates.emplace_back(bound, i, j);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

double RadiusAbout(const AlignedBox3d& box) {
  return box.diagonal().norm() / 2;
}

}  // namespace

PointCloud::PointCloud(std::vector<Vector3d> points_W)
    : points_(std::move(points_W)) {
  AlignedBox3d box;
  for (const Vector3d& point : points_) box.extend(point);
  if (points_.empty()) return;
  centre_ = box.center();
  radius_ = RadiusAbout(box);
}

struct PartShape::Collision {
  struct Posed {
    Geometry geometry;
    Isometry3d X_OG;  // FCL's frame of the geometry
  };
  std::vector<Posed> solids;
};

PartShape::PartShape(const Part& part)
    : collision_(std::make_unique<Collision>()) {
  for (const Piece& piece : part.pieces) {
    if (!piece.is_shape) continue;
    solids_.emplace_back(piece);
    box_.extend(solids_.back().box());
    const bool is_hull = piece.kind == Piece::Kind::kHull;
    collision_->solids.push_back(
        {MakeGeometry(piece), is_hull ? Isometry3d::Identity() : piece.X_OP});
  }
  if (solids_.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: no piece counts for distances", part.name));
  }
}

PartShape::~PartShape() = default;
PartShape::PartShape(PartShape&&) noexcept = default;

double PartShape::Distance(const PartShape& a, const Isometry3d& X_WA,
                           const PartShape& b, const Isometry3d& X_WB,
                           double cutoff, double enough) {
  const double between =
      (X_WA * a.box_.center() - X_WB * b.box_.center()).norm();
  if (between - RadiusAbout(a.box_) - RadiusAbout(b.box_) >= cutoff) {
    return cutoff;
  }
  const Isometry3d X_AB = X_WA.inverse() * X_WB;
  double nearest = cutoff;
  for (const auto& [bound, i, j] : NearPairs(a, b, X_AB, cutoff)) {
    if (bound >= nearest || nearest <= enough) break;
    const Collision::Posed& solid_a = a.collision_->solids[i];
    const Collision::Posed& solid_b = b.collision_->solids[j];
    nearest = std::min(nearest,
                       ConvexDistance(solid_a.geometry, solid_a.X_OG,
                                      solid_b.geometry, X_AB * solid_b.X_OG));
  }
  return nearest;
}

double PartShape::DistanceTo(const PointCloud& cloud, const Isometry3d& X_WO,
                             double cutoff, double enough) const {
  const Isometry3d X_OW = X_WO.inverse();
  if (cloud.points().empty() ||
      box_.exteriorDistance(X_OW * cloud.centre()) - cloud.radius() >= cutoff) {
    return cutoff;
  }
  // Most points of a cloud are far from the part: outside a sphere around its
  // box, larger by what rounding could change.
  const Vector3d centre_W = X_WO * box_.center();
  const double radius = 0.5 * box_.diagonal().norm() + 1e-9;
  double nearest = cutoff;
  for (const Vector3d& p_W : cloud.points()) {
    const double reach = radius + nearest;
    if ((p_W - centre_W).squaredNorm() >= reach * reach) continue;
    const Vector3d p_O = X_OW * p_W;
    if (box_.exteriorDistance(p_O) >= nearest) continue;
    for (const ConvexSolid& solid : solids_) {
      if (solid.box().exteriorDistance(p_O) >= nearest) continue;
      nearest = std::min(nearest, solid.DistanceTo(p_O));
    }
    if (nearest <= enough) break;
  }
  return nearest;
}

double PartShape::Reach(const Vector3d& n_O) const {
  double reach = -std::numeric_limits<double>::infinity();
  for (const ConvexSolid& solid : solids_) {
    reach = std::max(reach, solid.Support(n_O));
  }
  return reach;
}

double PartShape::LowestZ(const Isometry3d& X_WO) const {
  return X_WO.translation().z() - Reach(-X_WO.linear().row(2).transpose());
}

double PartShape::HighestZ(const Isometry3d& X_WO) const {
  return X_WO.translation().z() + Reach(X_WO.linear().row(2).transpose());
}

double PartShape::Slack(const Isometry3d& X_WO, const PartShape& content,
                        const Isometry3d& X_WB) const {
  const Isometry3d X_BO = X_WB.inverse() * X_WO;
  double slack = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d n_B = X_BO.linear().col(axis);
    const double offset = n_B.dot(X_BO.translation());
    const double high = content.Reach(n_B) - offset;
    const double low = -content.Reach(-n_B) - offset;
    slack = std::min({slack, box_.max()[axis] - high, low - box_.min()[axis]});
  }
  return slack;
}

std::vector<PartShape> ShapesOf(const PartTable& table) {
  std::vector<PartShape> shapes;
  for (const Part& part : table.parts()) shapes.emplace_back(part);
  return shapes;
}

}  // namespace cell
