#include "common/arms/cell_check.h"

#include <fmt/format.h>

#include "common/arms/arm_scene.h"

namespace cell {
namespace {

constexpr double kHomeClearance = 0.010;  // [m]
constexpr double kUpright = 0.9999;       // cosine: its plinth is a box

std::optional<std::string> WhyArmImpossible(const ArmLayout& arm,
                                            const ArmScene& scene) {
  const std::string key = "arms." + arm.name;
  if (arm.X_WB.translation().z() < 0) {
    return key + ".base: lies below the table's top";
  }
  if (arm.X_WB.linear()(2, 2) < kUpright) return key + ".base: leans";
  if (arm.tool_mass > arm.model->payload()) {
    return fmt::format("{}.tool.mass: a {} carries {} kg", key,
                       arm.model->name(), arm.model->payload());
  }
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(arm.exchange.min()),
                                   Eigen::Vector2d(arm.exchange.max())}) {
    if (!arm.workspace.contains(Eigen::Vector3d(p.x(), p.y(), 0))) {
      return key + ".exchange: reaches out of the arm's workspace";
    }
  }
  if (const auto why =
          scene.WhyBlocked(arm.name, HomePosture(arm), {kHomeClearance, {}})) {
    return fmt::format("{}.home: {}", key, *why);
  }
  if (!arm.workspace.contains(GripperPose(arm, arm.home).translation())) {
    return key + ".home: the gripper is outside the arm's workspace";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> WhyCellImpossible(const PartTable& parts,
                                             const CellLayout& layout) {
  const ArmScene scene(parts, layout);
  for (const ArmLayout& arm : layout.arms) {
    if (auto why = WhyArmImpossible(arm, scene)) return why;
  }
  return std::nullopt;
}

void CheckCell(const Config& cell_config, const PartTable& parts,
               const CellLayout& layout) {
  if (const auto why = WhyCellImpossible(parts, layout)) {
    throw ConfigError(fmt::format("{}:{}", cell_config.file(), *why));
  }
}

}  // namespace cell
