#include "common/parts/piece_config.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "common/geometry/degree.h"

namespace cell {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double Extent(const Config& config, const std::string& key) {
  return kMm * config.Number(key, 1e-3, kMaxLength);
}

Vector2d Point2(const Config& config, const std::string& key) {
  const std::vector<double> p = config.Numbers(key, 2);
  return kMm * Vector2d(p[0], p[1]);
}

Vector3d Point3(const Config& config, const std::string& key) {
  const std::vector<double> p = config.Numbers(key, 3);
  return kMm * Vector3d(p[0], p[1], p[2]);
}

struct Range {
  double low = 0;
  double high = 0;
};

Range Interval(const Config& config, const std::string& key, double unit) {
  const std::vector<double> z = config.Numbers(key, 2);
  if (!(z[0] < z[1])) config[key].Fail("should be ascending");
  return {unit * z[0], unit * z[1]};
}

Vector2d Polar(const Vector2d& center, double radius, double angle) {
  return center + radius * Vector2d(std::cos(angle), std::sin(angle));
}

Piece Box(const Config& config) {
  Piece piece;
  piece.kind = Piece::Kind::kBox;
  piece.X_OP.translation() = Point3(config, "center");
  piece.X_OP.linear() =
      Eigen::AngleAxisd(kDegree * config.GetOr("yaw", 0.0), Vector3d::UnitZ())
          .toRotationMatrix();
  piece.half_extents = Point3(config, "size") / 2;
  if (!(piece.half_extents.minCoeff() > 0)) {
    config["size"].Fail("has no volume");
  }
  return piece;
}

Piece Cylinder(const Config& config) {
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.X_OP.translation() = Point3(config, "center");
  const auto axis = config.Get<std::string>("axis");
  if (axis != "x" && axis != "y" && axis != "z") {
    config["axis"].Fail("should be x, y or z: '" + axis + "'");
  }
  const Vector3d along(axis == "x", axis == "y", axis == "z");
  piece.X_OP.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along)
          .toRotationMatrix();
  piece.radius = Extent(config, "radius");
  piece.half_length = Extent(config, "length") / 2;
  return piece;
}

Piece Prism(const Config& config) {
  std::vector<Vector2d> outline;
  const Config list = config["outline"];
  for (const auto& p : list.As<std::vector<std::vector<double>>>()) {
    if (p.size() != 2) list.Fail("needs points of two numbers");
    outline.push_back(kMm * Vector2d(p[0], p[1]));
  }
  if (outline.size() < 3) list.Fail("needs three points");
  const Range z = Interval(config, "z", kMm);
  return MakePrism(outline, z.low, z.high);
}

/// The wedge between the planes through the hole's axis at two angles: its
/// profile over (distance from the axis in its own direction, z) is the same
/// hexagon in both planes except for the outer edge.
struct WedgeProfile {
  double apothem, outer;
  Range z;
  double chamfer_low, chamfer_high;

  /// Corners in the plane with its inner and outer edges `inner_scale` and
  /// `outer_scale` times as far out, counter-clockwise in (distance, z).
  std::vector<Vector2d> At(double inner_scale, double outer_scale) const {
    std::vector<Vector2d> corners{
        {(apothem + chamfer_low) * inner_scale, z.low},
        {outer * outer_scale, z.low},
        {outer * outer_scale, z.high},
        {(apothem + chamfer_high) * inner_scale, z.high}};
    if (chamfer_high > 0) {
      corners.emplace_back(apothem * inner_scale, z.high - chamfer_high);
    }
    if (chamfer_low > 0) {
      corners.emplace_back(apothem * inner_scale, z.low + chamfer_low);
    }
    return corners;
  }
};

Piece Wedge(const WedgeProfile& profile, const Vector2d& center,
            double rotation, double from, double to) {
  Piece wedge;
  wedge.kind = Piece::Kind::kHull;
  const double inner_scale = 1 / std::cos((to - from) / 2);
  const double side = std::round((from + to) / std::numbers::pi) *
                      (std::numbers::pi / 2);  // of the block
  for (const double angle : {from, to}) {
    for (const Vector2d& corner :
         profile.At(inner_scale, 1 / std::cos(angle - side))) {
      const Vector2d p = Polar(center, corner.x(), angle + rotation);
      wedge.vertices.emplace_back(p.x(), p.y(), corner.y());
    }
  }
  const int n = static_cast<int>(wedge.vertices.size()) / 2;
  std::vector<int> start, end;
  for (int i = 0; i < n; ++i) {
    start.push_back(i);
    end.push_back(2 * n - 1 - i);
    const int next = (i + 1) % n;
    wedge.faces.push_back({i, i + n, next + n, next});
  }
  wedge.faces.push_back(start);
  wedge.faces.push_back(end);
  return wedge;
}

std::vector<Piece> Hole(const Config& config) {
  const int sides = config.Integer("sides", 4, 64);
  if (sides != 4 && sides % 8 != 0) {
    config["sides"].Fail(fmt::format("{} is not 4 or a multiple of 8", sides));
  }
  WedgeProfile profile{};
  profile.apothem = Extent(config, "apothem");
  profile.outer = config.Has("corner")
                      ? Extent(config, "corner") / std::numbers::sqrt2
                      : Extent(config, "outer");
  profile.z = Interval(config, "z", kMm);
  const std::vector<double> chamfer = config.Numbers("chamfer", 2);
  profile.chamfer_low = kMm * chamfer[0];
  profile.chamfer_high = kMm * chamfer[1];
  if (profile.chamfer_low < 0 || profile.chamfer_high < 0 ||
      profile.chamfer_low + profile.chamfer_high >=
          profile.z.high - profile.z.low) {
    config["chamfer"].Fail("does not fit into the thickness");
  }
  const double mouth = profile.apothem + kMm * std::max(chamfer[0], chamfer[1]);
  if (mouth / std::cos(std::numbers::pi / sides) >=
      profile.outer / std::cos(std::numbers::pi / sides)) {
    config["apothem"].Fail("the hole with its chamfer leaves no wall");
  }
  const Vector2d center = Point2(config, "center");
  const double rotation = kDegree * config.GetOr("rotation", 0.0);
  const double step = 2 * std::numbers::pi / sides;
  std::vector<Piece> wedges;
  for (int i = 0; i < sides; ++i) {
    const double from = std::numbers::pi / 4 + i * step;
    wedges.push_back(Wedge(profile, center, rotation, from, from + step));
  }
  return wedges;
}

std::vector<Piece> RingSector(const Config& config) {
  const Vector2d center = Point2(config, "center");
  const Range z = Interval(config, "z", kMm);
  const Range radii = Interval(config, "radii", kMm);
  const Range angles = Interval(config, "angles", kDegree);
  const int segments = config.Integer("segments", 1, 90);
  const double step = (angles.high - angles.low) / segments;
  std::vector<Piece> quads;
  for (int i = 0; i < segments; ++i) {
    const double a = angles.low + i * step;
    const double b = a + step;
    quads.push_back(
        MakePrism({Polar(center, radii.low, a), Polar(center, radii.high, a),
                   Polar(center, radii.high, b), Polar(center, radii.low, b)},
                  z.low, z.high));
  }
  return quads;
}

Piece DiscSegment(const Config& config) {
  const Vector2d center = Point2(config, "center");
  const Range z = Interval(config, "z", kMm);
  const double radius = Extent(config, "radius");
  const Range angles = Interval(config, "angles", kDegree);
  const int segments = config.Integer("segments", 2, 90);
  std::vector<Vector2d> outline;
  for (int i = 0; i <= segments; ++i) {
    outline.push_back(
        Polar(center, radius,
              angles.low + (angles.high - angles.low) * i / segments));
  }
  return MakePrism(outline, z.low, z.high);
}

std::vector<Piece> OfKind(const Config& config) {
  const auto kind = config.Get<std::string>("kind");
  if (kind == "box") return {Box(config)};
  if (kind == "cylinder") return {Cylinder(config)};
  if (kind == "prism") return {Prism(config)};
  if (kind == "hole") return Hole(config);
  if (kind == "ring_sector") return RingSector(config);
  if (kind == "disc_segment") return {DiscSegment(config)};
  config["kind"].Fail("not a kind of piece: '" + kind + "'");
}

}  // namespace

std::vector<Piece> PiecesFromConfig(const Config& config) {
  std::vector<Piece> pieces = OfKind(config);
  const auto contact_class = config.GetOr<std::string>("contact", "");
  const bool is_shape = config.GetOr("shape", true);
  if (contact_class.empty() && !is_shape) {
    config.Fail("has neither a shape nor a contact class");
  }
  for (Piece& piece : pieces) {
    piece.contact_class = contact_class;
    piece.is_shape = is_shape;
    const std::string reason = WhyNotConvex(AsHull(piece));
    if (!reason.empty()) config.Fail(reason);
  }
  if (config.GetOr("mirror_x", false)) {
    const size_t count = pieces.size();
    for (size_t i = 0; i < count; ++i) {
      pieces.push_back(MirroredInX(pieces[i]));
    }
  }
  return pieces;
}

Eigen::Isometry3d PoseInMm(const Config& config) {
  const std::vector<double> xyz = config.Numbers("xyz", 3);
  const std::vector<double> rpy = config.Has("rpy")
                                      ? config.Numbers("rpy", 3)
                                      : std::vector<double>{0, 0, 0};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = kMm * Vector3d(xyz[0], xyz[1], xyz[2]);
  X.linear() = (Eigen::AngleAxisd(kDegree * rpy[2], Vector3d::UnitZ()) *
                Eigen::AngleAxisd(kDegree * rpy[1], Vector3d::UnitY()) *
                Eigen::AngleAxisd(kDegree * rpy[0], Vector3d::UnitX()))
                   .toRotationMatrix();
  return X;
}

}  // namespace cell
