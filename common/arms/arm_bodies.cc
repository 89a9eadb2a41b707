#include "common/arms/arm_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPlinthRim = 0.005;  // [m] around the arm's foot
constexpr std::array<double, 3> kPlinthColour = {0.20, 0.21, 0.23};
constexpr std::array<double, 3> kLinkColour = {0.62, 0.65, 0.69};
constexpr std::array<double, 3> kJointColour = {0.25, 0.42, 0.58};
constexpr std::array<double, 3> kHandColour = {0.30, 0.32, 0.36};

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

}  // namespace

ArmPosture HomePosture(const ArmLayout& arm) {
  return {arm.home, arm.hand.grips.front().name, arm.hand.max_opening / 2};
}

std::vector<Part> BodyPartsOf(const ArmLayout& arm) {
  const std::string prefix = "arm_" + arm.name + ".";
  const double half_height = arm.X_WB.translation().z() / 2;
  const double half_plinth = arm.model->bodies().base_radius + kPlinthRim;
  std::vector<Part> parts;
  parts.push_back(
      Body(prefix + "plinth",
           {Box({half_plinth, half_plinth, std::max(half_height, 1e-3)})},
           kPlinthColour));
  parts.push_back(Body(prefix + "base", arm.model->bodies().base, kLinkColour));
  int index = 0;
  for (const std::vector<Piece>& pieces : arm.model->bodies().links) {
    ++index;
    const bool is_long = index == 2 || index == 3;
    parts.push_back(Body(fmt::format("{}link_{}", prefix, index), pieces,
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
  X_W.reserve(ArmModel::kNumBodies + arm.hand.boxes.size());
  X_W.push_back(arm.X_WB *
                Eigen::Translation3d(0, 0, -arm.X_WB.translation().z() / 2));
  X_W.push_back(arm.X_WB);
  for (const Isometry3d& X_BL : arm.model->LinkPoses(posture.q)) {
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

Part PedestalBody(const CellLayout::Pedestal& pedestal) {
  Eigen::Vector3d half_extents;
  half_extents << pedestal.size / 2, pedestal.height / 2;
  Piece box = Box(half_extents);
  box.X_OP.translation().z() = -half_extents.z();
  return Body("pedestal", {box}, kPlinthColour);
}

Isometry3d GripperPose(const ArmLayout& arm, const Joints& q) {
  return arm.X_WB * arm.model->FlangePose(q) * arm.X_FG;
}

Isometry3d FlangePoseFor(const ArmLayout& arm, const Isometry3d& X_WG) {
  return arm.X_WB.inverse() * X_WG * arm.X_FG.inverse();
}

}  // namespace cell
