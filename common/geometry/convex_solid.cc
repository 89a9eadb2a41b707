#include "common/geometry/convex_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cell {
namespace {

using Eigen::Vector3d;

double DistanceToSegment(const Vector3d& p, const Vector3d& a,
                         const Vector3d& b) {
  const Vector3d ab = b - a;
  const double t = std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
  return (a + t * ab - p).norm();
}

}  // namespace

ConvexSolid::ConvexSolid(const Piece& piece)
    : piece_(piece), X_PO_(piece.X_OP.inverse()) {
  for (const std::vector<int>& indices : piece_.faces) {
    Face& face = faces_.emplace_back();
    for (const int i : indices) {
      face.vertices.push_back(piece_.vertices.at(static_cast<size_t>(i)));
    }
    face.normal = (face.vertices.at(1) - face.vertices.at(0))
                      .cross(face.vertices.at(2) - face.vertices.at(0))
                      .normalized();
  }
  Vector3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    high[axis] = Support(Vector3d::Unit(axis));
    low[axis] = -Support(-Vector3d::Unit(axis));
  }
  box_ = {low, high};
  centre_ = box_.center();
  switch (piece_.kind) {
    case Piece::Kind::kBox:
      radius_ = piece_.half_extents.norm();
      break;
    case Piece::Kind::kCylinder:
      radius_ = std::hypot(piece_.radius, piece_.half_length);
      break;
    case Piece::Kind::kHull:
      for (const Vector3d& vertex : piece_.vertices) {
        radius_ = std::max(radius_, (vertex - centre_).norm());
      }
      break;
  }
}

double ConvexSolid::DistanceTo(const Vector3d& p_O) const {
  switch (piece_.kind) {
    case Piece::Kind::kBox:
      return ((X_PO_ * p_O).cwiseAbs() - piece_.half_extents)
          .cwiseMax(0)
          .norm();
    case Piece::Kind::kCylinder: {
      const Vector3d p_P = X_PO_ * p_O;
      const double radial = p_P.head<2>().norm() - piece_.radius;
      const double axial = std::abs(p_P.z()) - piece_.half_length;
      return std::hypot(std::max(radial, 0.0), std::max(axial, 0.0));
    }
    case Piece::Kind::kHull:
      return DistanceToHull(p_O);
  }
  return std::numeric_limits<double>::infinity();
}

// Outside, the nearest point lies on a face that the point is in front of:
// above its polygon, or on one of its edges.
double ConvexSolid::DistanceToHull(const Vector3d& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face& face : faces_) {
    const double height = face.normal.dot(p - face.vertices[0]);
    if (height <= 0 || height >= nearest) continue;
    bool is_above = true;
    for (size_t i = 0; i < face.vertices.size(); ++i) {
      const Vector3d& a = face.vertices[i];
      const Vector3d& b = face.vertices[(i + 1) % face.vertices.size()];
      if (face.normal.cross(b - a).dot(p - a) >= 0) continue;
      is_above = false;
      nearest = std::min(nearest, DistanceToSegment(p, a, b));
    }
    if (is_above) nearest = std::min(nearest, height);
  }
  return std::isinf(nearest) ? 0 : nearest;
}

double ConvexSolid::Support(const Vector3d& n_O) const {
  if (piece_.kind == Piece::Kind::kHull) {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vector3d& vertex : piece_.vertices) {
      reach = std::max(reach, n_O.dot(vertex));
    }
    return reach;
  }
  const Vector3d n_P = piece_.X_OP.linear().transpose() * n_O;
  const double reach = piece_.kind == Piece::Kind::kBox
                           ? n_P.cwiseAbs().dot(piece_.half_extents)
                           : n_P.head<2>().norm() * piece_.radius +
                                 std::abs(n_P.z()) * piece_.half_length;
  return n_O.dot(piece_.X_OP.translation()) + reach;
}

}  // namespace cell
