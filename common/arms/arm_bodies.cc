#include "common/arms/arm_bodies.h"

#include <fmt/format.h>

#include <numbers>

#include "common/arms/ur5.h"

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPlinth = 0.16;  // [m] width
constexpr std::array<double, 3> kLinkColour = {0.55, 0.60, 0.66};
constexpr std::array<double, 3> kJointColour = {0.25, 0.40, 0.55};

/// A tube from a to b.
Piece Tube(const Vector3d& a, const Vector3d& b, double radius) {
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.radius = radius;
  piece.half_length = (b - a).norm() / 2;
  piece.X_OP.translation() = (a + b) / 2;
  piece.X_OP.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), b - a)
          .toRotationMatrix();
  return piece;
}

Piece Box(const Vector3d& half_extents) {
  Piece piece;
  piece.half_extents = half_extents;
  return piece;
}

Part Body(const std::string& name, std::vector<Piece> pieces,
          const std::array<double, 3>& colour) {
  Part body;
  body.name = name;
  body.pieces = std::move(pieces);
  body.is_fixed = true;
  body.colour = colour;
  return body;
}

}  // namespace

std::vector<Part> ArmLinks(const ArmLayout& arm) {
  const std::string prefix = "arm_" + arm.name + ".";
  const double height = arm.X_WB.translation().z();
  // In the frames of ur5.h: the upper arm runs beside the plane of frame 2,
  // the forearm nearer to it.
  return {
      Body(prefix + "plinth",
           {Box({kPlinth / 2, kPlinth / 2, std::max(height / 2, 1e-3)})},
           kJointColour),
      Body(prefix + "base", {Tube({0, 0, 0}, {0, 0, 0.045}, 0.075)},
           kLinkColour),
      Body(prefix + "link_1",
           {Tube({0, -0.045, 0}, {0, 0.062, 0}, 0.062),
            Tube({0, 0, -0.062}, {0, 0, 0.075}, 0.062)},
           kJointColour),
      Body(prefix + "link_2",
           {Tube({0.425, 0, 0.075}, {0.425, 0, 0.195}, 0.060),
            Tube({0.425, 0, 0.136}, {0, 0, 0.136}, 0.056),
            Tube({0, 0, 0.080}, {0, 0, 0.190}, 0.055)},
           kLinkColour),
      Body(prefix + "link_3",
           {Tube({0.392, 0, -0.035}, {0.392, 0, 0.078}, 0.050),
            Tube({0.392, 0, 0.016}, {0, 0, 0.016}, 0.046),
            Tube({0, 0, -0.035}, {0, 0, 0.062}, 0.043)},
           kLinkColour),
      Body(prefix + "link_4",
           {Tube({0, -0.047, 0}, {0, 0.045, 0}, 0.043),
            Tube({0, 0, -0.050}, {0, 0, 0.047}, 0.043)},
           kJointColour),
      Body(prefix + "link_5",
           {Tube({0, -0.045, 0}, {0, 0.047, 0}, 0.043),
            Tube({0, 0, -0.050}, {0, 0, 0.040}, 0.043)},
           kJointColour),
      Body(prefix + "link_6", {Tube({0, 0, -0.042}, {0, 0, 0}, 0.038)},
           kLinkColour),
  };
}

std::vector<NamedPose> ArmLinkPoses(const ArmLayout& arm, const Joints& q) {
  const std::string prefix = "arm_" + arm.name + ".";
  Isometry3d X_WP = arm.X_WB;
  X_WP.translation().z() /= 2;
  std::vector<NamedPose> poses = {{prefix + "plinth", X_WP},
                                  {prefix + "base", arm.X_WB}};
  int number = 0;
  for (const Isometry3d& X_BL : ur5::LinkPoses(q)) {
    poses.emplace_back(fmt::format("{}link_{}", prefix, ++number),
                       arm.X_WB * X_BL);
  }
  return poses;
}

std::vector<Part> HandBoxes(const std::string& hand, const HandType& type) {
  std::vector<Part> boxes;
  for (const HandType::Box& box : type.boxes) {
    boxes.push_back(Body(hand + "." + box.name, {Box(box.half_extents)},
                         {0.30, 0.32, 0.36}));
  }
  return boxes;
}

std::vector<NamedPose> HandBoxPoses(const std::string& hand,
                                    const HandType& type,
                                    const Isometry3d& X_WG,
                                    const std::string& grip, double opening) {
  const HandType::Grip* found = type.FindGrip(grip);
  if (found == nullptr) found = &type.grips.front();
  std::vector<NamedPose> poses;
  for (size_t i = 0; i < type.boxes.size(); ++i) {
    poses.emplace_back(hand + "." + type.boxes[i].name,
                       X_WG * HandType::PlaceOf(*found, i, opening));
  }
  return poses;
}

}  // namespace cell
