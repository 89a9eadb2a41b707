#include "services/vtb/within_reach.h"

#include <algorithm>

namespace cell::vtb {
namespace {

constexpr double kFromBorder = 0.004;  // [m] of the workspaces
constexpr double kApproach = 0.110;    // [m]
constexpr double kOpenMargin = 0.030;  // [m]
constexpr double kClearance = 0.003;   // [m]

CellLayout Narrowed(CellLayout layout) {
  const Eigen::Vector3d border = Eigen::Vector3d::Constant(kFromBorder);
  for (ArmLayout& arm : layout.arms) {
    arm.workspace = {arm.workspace.min() + border,
                     arm.workspace.max() - border};
  }
  return layout;
}

ArmScene SceneOf(const ArmScene& empty,
                 const std::vector<PlacementSampler::Placed>& placed) {
  ArmScene scene = empty;
  for (const auto& [part, X_WO] : placed) scene.PutPart(part, X_WO);
  return scene;
}

}  // namespace

WithinReach::WithinReach(const PartTable& table, const CellLayout& layout)
    : layout_(Narrowed(layout)), empty_(table, layout_) {
  params_.approach = kApproach;
  params_.open_margin = kOpenMargin;
  params_.clearance = kClearance;
  params_.max_choices = 1;
}

bool WithinReach::CanTakeIn(const ArmScene& scene,
                            const std::string& part) const {
  return std::ranges::any_of(layout_.arms, [&](const ArmLayout& arm) {
    return bool(Reach(scene, arm.name, params_).Grasps(part, arm.home));
  });
}

bool WithinReach::CanTake(
    const std::string& part,
    const std::vector<PlacementSampler::Placed>& scene) const {
  return CanTakeIn(SceneOf(empty_, scene), part);
}

bool WithinReach::CanTakeAll(const std::vector<PlacementSampler::Placed>& scene,
                             const PlacementSampler::Starts& but) const {
  const ArmScene arm_scene = SceneOf(empty_, scene);
  return std::ranges::all_of(
      scene, [&](const PlacementSampler::Placed& placed) {
        return but.Has(placed.part) || CanTakeIn(arm_scene, placed.part);
      });
}

}  // namespace cell::vtb
