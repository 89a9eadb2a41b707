#include "services/vtb/gripper.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/box_surface.h"

namespace cell::vtb {
namespace {

constexpr double kSpacing = 0.006;  // [m] of the points on a finger
constexpr double kNear = 0.35;      // [m] of G: parts further off are not tried

}  // namespace

Gripper::Gripper(const std::string& name, const HandType& type,
                 const std::vector<PartShape>& shapes, const Params& params)
    : name_(name), type_(type), shapes_(shapes), params_(params) {
  for (const HandType::Box& box : type.boxes) {
    surfaces_.push_back(SampleBoxSurface(box.half_extents, kSpacing));
  }
  Reset(0);
}

void Gripper::Reset(double opening) {
  opening_ = goal_ = opening;
  grip_ = stance_ = type_.grips.front().name;
}

void Gripper::Command(double opening, const std::string& grip) {
  goal_ = std::clamp(opening, 0.0, type_.max_opening);
  if (type_.FindGrip(grip) != nullptr) grip_ = grip;
}

Gripper::State Gripper::state(const World& world) const {
  if (world.hands().HeldBy(name_)) return State::kGripping;
  return opening_ > 0 ? State::kOpen : State::kClosed;
}

void Gripper::Update(double dt, const Eigen::Isometry3d& X_WG, World& world) {
  Hands& hands = world.hands();
  const bool is_holding = hands.HeldBy(name_).has_value();
  const double step = params_.speed * dt;
  if (!is_holding) {
    stance_ = grip_;
    hands.PlaceFingers(name_, stance_);
    const double before = opening_;
    opening_ += std::clamp(goal_ - opening_, -step, step);
    hands.Move(name_, X_WG, opening_);
    if (opening_ >= before) return;
    if (const auto part = PartBetween(X_WG, world)) {
      hands.Grip(name_, *part);
      grip_opening_ = opening_;
    }
    return;
  }
  if (goal_ > grip_opening_ + params_.release) {
    hands.Release(name_);
    opening_ = std::min(goal_, opening_ + step);
  }
  hands.Move(name_, X_WG, opening_);
}

bool Gripper::IsFree(const World& world, size_t part) const {
  return !world.table().parts()[part].is_fixed;
}

/// The part that every finger touches.
std::optional<std::string> Gripper::PartBetween(const Eigen::Isometry3d& X_WG,
                                                const World& world) const {
  const HandType::Grip& grip = *type_.FindGrip(stance_);
  std::vector<PointCloud> fingers;
  for (size_t i = 0; i < grip.places.size(); ++i) {
    if (!HandType::IsFinger(grip.places[i])) continue;
    const Eigen::Isometry3d X_WB = X_WG * HandType::PlaceOf(grip, i, opening_);
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& p_B : surfaces_[i])
      points.push_back(X_WB * p_B);
    fingers.emplace_back(std::move(points));
  }
  for (size_t part = 0; part < shapes_.size(); ++part) {
    if (!IsFree(world, part)) continue;
    const std::string& name = world.table().parts()[part].name;
    const Eigen::Isometry3d X_WO = world.PoseOf(name);
    if ((X_WO.translation() - X_WG.translation()).norm() > kNear) continue;
    const bool is_between =
        std::ranges::all_of(fingers, [&](const PointCloud& finger) {
          return shapes_[part].DistanceTo(finger, X_WO, 2 * params_.touch) <
                 params_.touch;
        });
    if (is_between) return name;
  }
  return std::nullopt;
}

}  // namespace cell::vtb
