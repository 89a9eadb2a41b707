#include "services/vtb/hand_sweeps.h"

#include <algorithm>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;

double AngleBetween(const Isometry3d& a, const Isometry3d& b) {
  return Quaterniond(a.linear()).angularDistance(Quaterniond(b.linear()));
}

/// [m] From one pose to another, of no point within `size` [m] more.
double Displacement(const Isometry3d& a, const Isometry3d& b, double size) {
  return (a.translation() - b.translation()).norm() + size * AngleBetween(a, b);
}

}  // namespace

std::vector<HandSweep> SweepsOf(const CellLayout& layout, const Hands& hands) {
  std::vector<HandSweep> sweeps;
  const std::vector<BodyPose> bodies = hands.Bodies();
  for (const CellLayout::NamedHand& hand : layout.AllHands()) {
    const Hands::State& state = hands.StateOf(hand.name);
    const HandType::Grip& grip = hand.type->grips[state.grip];
    for (size_t box = 0; box < grip.places.size(); ++box) {
      const Isometry3d& X_WB = bodies[sweeps.size()].X_WB;
      const Isometry3d X_GB = Hands::PlaceOf(grip, box, state.opening);
      const Isometry3d X_GB_goal =
          Hands::PlaceOf(grip, box, state.opening_goal);
      const Eigen::Vector3d& half_extents = hand.type->boxes[box].half_extents;
      const double size = half_extents.norm();
      const double lever = size + std::max(X_GB.translation().norm(),
                                           X_GB_goal.translation().norm());
      // Fingers that are placed in another way are there at once.
      const double jump = Displacement(X_WB, state.X_WG * X_GB, size);
      const double travel = Displacement(state.X_WG, state.X_WG_goal, lever) +
                            Displacement(X_GB, X_GB_goal, size);
      sweeps.push_back({{X_WB, half_extents}, jump + travel});
    }
  }
  return sweeps;
}

}  // namespace cell::vtb
