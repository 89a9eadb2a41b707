#include "common/parts/cell_layout.h"

#include <numbers>

namespace cell {
namespace {

Eigen::Vector2d Vector2(const Config& config, const std::string& key) {
  const std::vector<double> v = config.Numbers(key, 2);
  return {v[0], v[1]};
}

Eigen::Vector3d Vector3(const Config& config, const std::string& key) {
  const std::vector<double> v = config.Numbers(key, 3);
  return {v[0], v[1], v[2]};
}

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

CellLayout::HandBox HandBoxFromConfig(const Config& config) {
  CellLayout::HandBox box;
  box.half_extents = Vector3(config, "size") / 2;
  if (!(box.half_extents.minCoeff() > 0)) config["size"].Fail("has no volume");
  box.z = config.Number("z", -10, 10);
  return box;
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
  const Config hands = config["hands"];
  layout.palm = HandBoxFromConfig(hands["palm"]);
  layout.thumb = HandBoxFromConfig(hands["thumb"]);
  layout.fingers = HandBoxFromConfig(hands["fingers"]);
  const Config rest = hands["rest"];
  for (const auto& [name, position] : rest.Entries()) {
    layout.hands.push_back({name, Vector3(rest, name)});
  }
  config.Finish();
  return layout;
}

}  // namespace cell
