#include "common/layout/arm_layout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "common/geometry/degree.h"
#include "common/kinematics/arm_models.h"
#include "common/layout/vectors.h"

namespace cell {
namespace {

Eigen::Isometry3d AlongZ(double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, z));
}

void LoadTool(const Config& config,
              const std::map<std::string, HandType>& types, ArmLayout* arm) {
  const auto hand = config.Get<std::string>("hand");
  const auto type = types.find(hand);
  if (type == types.end()) config["hand"].Fail("no such hand type: " + hand);
  arm->hand = type->second;
  arm->gripper = "gripper_" + arm->name;
  // G looks back at the flange: it approaches along its -z.
  arm->X_FG = AlongZ(config.Number("tcp", 0, 1)) *
              Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  if (config.Has("force_torque")) {
    arm->X_FS = AlongZ(config.Number("force_torque", 0, 1));
  }
  arm->tool_mass = config.Number("mass", 0, 10);
  arm->p_F_tool.z() = config.Number("centre_of_mass", 0, 1);
}

std::shared_ptr<const ArmModel> LoadModel(const Config& config) {
  const auto name = config.Get<std::string>("model");
  auto model = FindArmModel(name);
  if (model == nullptr) {
    config["model"].Fail(fmt::format("there is no arm model '{}'; known: {}",
                                     name, fmt::join(ArmModelNames(), ", ")));
  }
  return model;
}

Joints LoadHome(const Config& config, const ArmLayout& arm) {
  const auto q = arm.model->SolveNear(
      arm.X_WB.inverse() * PoseFromConfig(config) * arm.X_FG.inverse(),
      arm.model->ready());
  if (!q) config.Fail("out of reach of a " + arm.model->name());
  constexpr double kTenths = 10 / kDegree;
  return q->unaryExpr(
      [](double angle) { return std::round(kTenths * angle) / 10 * kDegree; });
}

}  // namespace

ArmLayout ArmLayout::FromConfig(const std::string& name, const Config& config,
                                const std::map<std::string, HandType>& types) {
  ArmLayout arm;
  arm.name = name;
  arm.model = LoadModel(config);
  arm.X_WB = PoseFromConfig(config["base"]);
  arm.precedence = config.Integer("precedence", 1, 100);
  LoadTool(config["tool"], types, &arm);
  arm.home = LoadHome(config["home"], arm);
  const Config workspace = config["workspace"];
  arm.workspace = Eigen::AlignedBox3d(Vector3(workspace, "low"),
                                      Vector3(workspace, "high"));
  if (arm.workspace.isEmpty()) workspace.Fail("low lies above high");
  const Config exchange = config["exchange"];
  arm.exchange =
      Eigen::AlignedBox2d(Vector2(exchange, "low"), Vector2(exchange, "high"));
  if (arm.exchange.isEmpty()) exchange.Fail("low lies above high");
  return arm;
}

std::string ChannelSuffix(const std::string& arm) {
  std::string suffix = arm;
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  return suffix;
}

}  // namespace cell
