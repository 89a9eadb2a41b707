#include "common/arms/arm_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "common/arms/ur5.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kHalfPlinth = 0.08;  // [m] of its square
constexpr std::array<double, 3> kPlinthColour = {0.20, 0.21, 0.23};
constexpr std::array<double, 3> kLinkColour = {0.62, 0.65, 0.69};
constexpr std::array<double, 3> kJointColour = {0.25, 0.42, 0.58};
constexpr std::array<double, 3> kHandColour = {0.30, 0.32, 0.36};

// [m] of a UR5's housings: what its datasheet draws, rounded up.
constexpr double kBaseRadius = 0.075, kShoulderRadius = 0.060,
                 kUpperArmRadius = 0.058, kForearmRadius = 0.050,
                 kWristRadius = 0.046;
// [m] The upper arm and the forearm run beside the plane through the shoulder.
constexpr double kUpperArmSide = 0.136, kForearmSide = 0.016;

enum class Axis { kX, kY, kZ };

// From `low` to `high` along an axis through `centre`.
Piece Cylinder(Axis axis, double radius, double low, double high,
               const Vector3d& centre = Vector3d::Zero()) {
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.radius = radius;
  piece.half_length = (high - low) / 2;
  const Vector3d along = Vector3d::Unit(static_cast<int>(axis));
  piece.X_OP.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along)
          .toRotationMatrix();
  piece.X_OP.translation() = centre + along * (low + high) / 2;
  return piece;
}

Piece Box(const Vector3d& half_extents) {
  Piece piece;
  piece.kind = Piece::Kind::kBox;
  piece.half_extents = half_extents;
  return piece;
}

Part Body(std::string name, std::vector<Piece> pieces,
          const std::array<double, 3>& colour) {
  Part part;
  part.name = std::move(name);
  part.pieces = std::move(pieces);
  part.colour = colour;
  return part;
}

// In the frames 1..6. Frame 1: z along axis 2, y up. Frames 2 and 3: z along
// axes 3 and 4, x from the outer joint to the inner. Frame 4: y back along axis
// 4, z along axis 5. Frame 5: y back along axis 5, z along axis 6.
std::vector<std::vector<Piece>> LinkPieces() {
  const Vector3d shoulder(-ur5::kA2, 0, 0), elbow(-ur5::kA3, 0, 0);
  const Vector3d upper_arm(0, 0, kUpperArmSide), forearm(0, 0, kForearmSide);
  return {
      {Cylinder(Axis::kY, kShoulderRadius, -0.060, 0.060),
       Cylinder(Axis::kZ, kShoulderRadius, 0, 0.072)},
      {Cylinder(Axis::kZ, kShoulderRadius, 0.074, 0.198, shoulder),
       Cylinder(Axis::kX, kUpperArmRadius, 0, -ur5::kA2, upper_arm),
       Cylinder(Axis::kZ, kUpperArmRadius, 0.070, 0.198)},
      {Cylinder(Axis::kZ, kForearmRadius, -0.038, 0.068, elbow),
       Cylinder(Axis::kX, kForearmRadius, 0, -ur5::kA3, forearm),
       Cylinder(Axis::kZ, kWristRadius, -0.036, 0.060)},
      {Cylinder(Axis::kY, kWristRadius, -0.046, 0.046),
       Cylinder(Axis::kZ, kWristRadius, 0, 0.046)},
      {Cylinder(Axis::kY, kWristRadius, -0.046, 0.046),
       Cylinder(Axis::kZ, kWristRadius, 0, 0.046)},
      {Cylinder(Axis::kZ, kWristRadius, -0.034, 0)},
  };
}

}  // namespace

ArmPosture HomePosture(const ArmLayout& arm) {
  return {arm.home, arm.hand.grips.front().name, arm.hand.max_opening / 2};
}

std::vector<Part> BodyPartsOf(const ArmLayout& arm) {
  const std::string prefix = "arm_" + arm.name + ".";
  const double half_height = arm.X_WB.translation().z() / 2;
  std::vector<Part> parts;
  parts.push_back(
      Body(prefix + "plinth",
           {Box({kHalfPlinth, kHalfPlinth, std::max(half_height, 1e-3)})},
           kPlinthColour));
  parts.push_back(Body(prefix + "base",
                       {Cylinder(Axis::kZ, kBaseRadius, 0, 0.028)},
                       kLinkColour));
  int index = 0;
  for (std::vector<Piece>& pieces : LinkPieces()) {
    ++index;
    const bool is_long = index == 2 || index == 3;
    parts.push_back(Body(fmt::format("{}link_{}", prefix, index),
                         std::move(pieces),
                         is_long ? kLinkColour : kJointColour));
  }
  std::ranges::move(HandPartsOf(arm.gripper, arm.hand),
                    std::back_inserter(parts));
  return parts;
}

std::vector<Part> HandPartsOf(const std::string& hand, const HandType& type) {
  std::vector<Part> parts;
  for (const HandType::Box& box : type.boxes) {
    parts.push_back(
        Body(hand + "." + box.name, {Box(box.half_extents)}, kHandColour));
  }
  return parts;
}

std::vector<Isometry3d> BodyPosesOf(const ArmLayout& arm,
                                    const ArmPosture& posture) {
  const HandType::Grip* grip = arm.hand.FindGrip(posture.grip);
  if (grip == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} has no grip '{}'", arm.gripper, posture.grip));
  }
  std::vector<Isometry3d> X_W;
  X_W.reserve(kNumArmBodies + arm.hand.boxes.size());
  X_W.push_back(arm.X_WB *
                Eigen::Translation3d(0, 0, -arm.X_WB.translation().z() / 2));
  X_W.push_back(arm.X_WB);
  for (const Isometry3d& X_BL : ur5::LinkPoses(posture.q)) {
    X_W.push_back(arm.X_WB * X_BL);
  }
  const Isometry3d X_WG = X_W.back() * arm.X_FG;
  for (size_t i = 0; i < arm.hand.boxes.size(); ++i) {
    X_W.push_back(X_WG * HandType::PlaceOf(*grip, i, posture.opening));
  }
  return X_W;
}

std::map<std::string, Isometry3d> NamedBodyPosesOf(const ArmLayout& arm,
                                                   const ArmPosture& posture) {
  const std::vector<Part> parts = BodyPartsOf(arm);
  const std::vector<Isometry3d> X_W = BodyPosesOf(arm, posture);
  std::map<std::string, Isometry3d> named;
  for (size_t i = 0; i < parts.size(); ++i) named[parts[i].name] = X_W[i];
  return named;
}

bool MayCollide(size_t body_a, size_t body_b) {
  const size_t inner = std::min(body_a, body_b);
  const size_t outer = std::max(body_a, body_b);
  constexpr size_t kWrist = kFirstLinkBody + 4;  // link 5
  constexpr size_t kUpperArm = kFirstLinkBody + 1;
  if (outer >= kNumArmBodies) return inner < kWrist;  // a box of the hand
  // The upper arm's housing turns right above the base.
  if (inner == kBaseBody && outer == kUpperArm) return false;
  // The plinth is a neighbour of what turns on it, and so are three in a row of
  // the wrist, whose axes meet.
  if (inner == kPlinthBody) return outer > kFirstLinkBody;
  const bool is_wrist = inner >= kFirstLinkBody + 2;
  return outer - inner > (is_wrist ? 2u : 1u);
}

Part PedestalBody(const CellLayout::Pedestal& pedestal) {
  Eigen::Vector3d half_extents;
  half_extents << pedestal.size / 2, pedestal.height / 2;
  Piece box = Box(half_extents);
  box.X_OP.translation().z() = -half_extents.z();
  return Body("pedestal", {box}, kPlinthColour);
}

Isometry3d GripperPose(const ArmLayout& arm, const Joints& q) {
  return arm.X_WB * ur5::FlangePose(q) * arm.X_FG;
}

Isometry3d FlangePoseFor(const ArmLayout& arm, const Isometry3d& X_WG) {
  return arm.X_WB.inverse() * X_WG * arm.X_FG.inverse();
}

}  // namespace cell
