#include "common/layout/cell_layout.h"

#include <algorithm>
#include <map>
#include <numbers>

#include "common/layout/vectors.h"

namespace cell {
namespace {

CellLayout::Pedestal PedestalFromConfig(const Config& config) {
  CellLayout::Pedestal pedestal;
  pedestal.size = Vector2(config, "size");
  if (!(pedestal.size.minCoeff() > 0)) config["size"].Fail("has no area");
  pedestal.height = config.Number("height", 0.001, 10);
  const Eigen::Vector2d xy = Vector2(config, "xy");
  pedestal.X_WP.translation() << xy, pedestal.height;
  const double yaw =
      config.Number("yaw_deg", -360, 360) * std::numbers::pi / 180;
  pedestal.X_WP.linear() =
      Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pedestal;
}

void LoadHands(const Config& config,
               const std::map<std::string, HandType>& types,
               std::vector<CellLayout::Hand>* hands) {
  for (const auto& [name, hand] : config.Entries()) {
    const auto type = types.find(hand.Get<std::string>("type"));
    if (type == types.end()) hand["type"].Fail("there is no such hand type");
    hands->push_back({name, type->second, Vector3(hand, "rest")});
  }
}

}  // namespace

CellLayout CellLayout::FromConfig(const Config& config) {
  CellLayout layout;
  layout.pedestal = PedestalFromConfig(config["pedestal"]);
  const Config workspace = config["workspace"];
  layout.workspace = Eigen::AlignedBox3d(Vector3(workspace, "low"),
                                         Vector3(workspace, "high"));
  if (layout.workspace.isEmpty()) workspace.Fail("low lies above high");
  const Config area = config["parts_area"];
  layout.parts_area = {Vector2(area, "centre"), Vector2(area, "size")};
  const auto types = HandTypesFromConfig(config["hand_types"]);
  LoadHands(config["hands"], types, &layout.hands);
  if (config.Has("arms")) {
    for (const auto& [name, arm] : config["arms"].Entries()) {
      layout.arms.push_back(ArmLayout::FromConfig(name, arm, types));
      const int precedence = layout.arms.back().precedence;
      if (std::ranges::count(layout.arms, precedence, &ArmLayout::precedence) >
          1) {
        arm["precedence"].Fail(
            "another arm has the same value; they must differ");
      }
    }
    std::ranges::sort(layout.arms, {}, &ArmLayout::name);
  }
  if (config.Has("cameras")) {
    layout.cameras = CameraLayout::FromConfig(config["cameras"]);
  }
  config.Finish();
  return layout;
}

std::vector<CellLayout::NamedHand> CellLayout::AllHands() const {
  std::vector<NamedHand> all;
  for (const Hand& hand : hands) all.push_back({hand.name, &hand.type});
  for (const ArmLayout& arm : arms) all.push_back({arm.gripper, &arm.hand});
  return all;
}

const ArmLayout* CellLayout::FindArm(const std::string& name) const {
  for (const ArmLayout& arm : arms) {
    if (arm.name == name) return &arm;
  }
  return nullptr;
}

}  // namespace cell
