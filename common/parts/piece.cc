#include "common/parts/piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Vertices may lie this far outside of a face through rounding.
constexpr double kFlatness = 1e-9;
constexpr double kMinVolume = 1e-12;

Piece Placed(Piece hull, const Eigen::Isometry3d& X_OP, const Piece& from) {
  for (Vector3d& vertex : hull.vertices) vertex = X_OP * vertex;
  hull.contact_class = from.contact_class;
  hull.is_shape = from.is_shape;
  return hull;
}

Vector3d FaceNormal(const Piece& hull, const std::vector<int>& face) {
  Vector3d normal = Vector3d::Zero();
  const Vector3d& p = hull.vertices.at(static_cast<size_t>(face.at(0)));
  for (size_t i = 1; i + 1 < face.size(); ++i) {
    normal +=
        (hull.vertices.at(static_cast<size_t>(face[i])) - p)
            .cross(hull.vertices.at(static_cast<size_t>(face[i + 1])) - p);
  }
  return normal.normalized();
}

/// Integrals of 1, x and x x^T over a body about the origin of O.
struct RawMoments {
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();

  /// Adds the tetrahedron between the origin and a triangle.
  void Add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double v = a.dot(b.cross(c)) / 6;
    const Vector3d sum = a + b + c;
    volume += v;
    first += v * sum / 4;
    second += v / 20 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() +
               sum * sum.transpose());
  }
};

void Add(const Piece& hull, RawMoments& raw) {
  for (const std::vector<int>& face : hull.faces) {
    const auto vertex = [&](size_t i) -> const Vector3d& {
      return hull.vertices.at(static_cast<size_t>(face.at(i)));
    };
    for (size_t i = 1; i + 1 < face.size(); ++i) {
      raw.Add(vertex(0), vertex(i), vertex(i + 1));
    }
  }
}

}  // namespace

Piece MakePrism(const std::vector<Vector2d>& outline, double z_low,
                double z_high) {
  Piece prism;
  prism.kind = Piece::Kind::kHull;
  const int n = static_cast<int>(outline.size());
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const Vector2d& p = outline[static_cast<size_t>(i)];
    prism.vertices.emplace_back(p.x(), p.y(), z_low);
    prism.vertices.emplace_back(p.x(), p.y(), z_high);
    top.push_back(2 * i + 1);
    bottom.push_back(2 * (n - 1 - i));
    const int next = (i + 1) % n;
    prism.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  prism.faces.push_back(bottom);
  prism.faces.push_back(top);
  return prism;
}

Piece AsHull(const Piece& piece, int num_sides) {
  if (piece.kind == Piece::Kind::kHull) return piece;
  if (piece.kind == Piece::Kind::kBox) {
    const double x = piece.half_extents.x();
    const double y = piece.half_extents.y();
    const double z = piece.half_extents.z();
    return Placed(MakePrism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, -z, z),
                  piece.X_OP, piece);
  }
  std::vector<Vector2d> outline;
  for (int i = 0; i < num_sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / num_sides;
    outline.emplace_back(piece.radius * std::cos(angle),
                         piece.radius * std::sin(angle));
  }
  return Placed(MakePrism(outline, -piece.half_length, piece.half_length),
                piece.X_OP, piece);
}

Piece MirroredInX(const Piece& piece) {
  Piece mirrored = AsHull(piece);
  if (piece.kind != Piece::Kind::kHull) {
    // A box or a cylinder is its own mirror image: mirror its frame only.
    const Eigen::DiagonalMatrix<double, 3> M(-1, 1, 1);
    mirrored = piece;
    mirrored.X_OP.translation() = M * piece.X_OP.translation();
    mirrored.X_OP.linear() = M * piece.X_OP.linear() * M;
    return mirrored;
  }
  for (Vector3d& vertex : mirrored.vertices) vertex.x() = -vertex.x();
  for (std::vector<int>& face : mirrored.faces) {
    std::reverse(face.begin(), face.end());
  }
  return mirrored;
}

VolumeMoments MomentsOf(const std::vector<Piece>& pieces) {
  // Enough sides that the prism's volume is that of the cylinder to 1e-3.
  constexpr int kNumSides = 96;
  RawMoments raw;
  for (const Piece& piece : pieces) {
    if (piece.is_shape) Add(AsHull(piece, kNumSides), raw);
  }
  VolumeMoments moments;
  if (raw.volume <= 0) return moments;
  moments.volume = raw.volume;
  moments.centre = raw.first / raw.volume;
  const Matrix3d second =
      raw.second - raw.volume * moments.centre * moments.centre.transpose();
  moments.inertia = second.trace() * Matrix3d::Identity() - second;
  return moments;
}

std::string WhyNotConvex(const Piece& hull) {
  for (const std::vector<int>& face : hull.faces) {
    const Vector3d normal = FaceNormal(hull, face);
    const Vector3d& p = hull.vertices.at(static_cast<size_t>(face.at(0)));
    for (const Vector3d& vertex : hull.vertices) {
      const double outside = normal.dot(vertex - p);
      if (!(outside <= kFlatness)) {
        return fmt::format(
            "not convex: a vertex lies {:.3g} mm outside of a face",
            1e3 * outside);
      }
    }
  }
  RawMoments raw;
  Add(hull, raw);
  if (!(raw.volume > kMinVolume)) {
    return fmt::format("has no volume ({:.3g} mm^3)", 1e9 * raw.volume);
  }
  return "";
}

}  // namespace cell
