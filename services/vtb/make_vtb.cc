#include <fmt/format.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "common/arms/cell_check.h"
#include "common/task/task.h"
#include "services/vtb/vtb.h"

namespace cell::vtb {
namespace {

constexpr double kTickSeconds = 1e-6 * kTickUs;

/// "a+b" is a, then b.
std::vector<std::string> SplitAtPlus(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, '+');) {
    names.push_back(name);
  }
  if (names.empty()) names.emplace_back();
  return names;
}

void LoadArms(const Config& config, ArmDevice::Params* params) {
  ArmServo::Params& servo = params->servo;
  servo.bandwidth = config.Number("bandwidth_hz", 1, 60);
  servo.dead_ticks = config.Integer("dead_ticks", 0, 20);
  servo.patience_ticks = config.Integer("patience_ticks", 1, 50);
  servo.stop_force = config.Number("stop_force_n", 10, 1000);
  params->gripper.speed = 1e-3 * config.Number("finger_speed_mm", 1, 1000);
  params->has_sensors = config.Get<bool>("sensors");
  const std::vector<double> bias = config.Numbers("sensor_bias", 6);
  params->bias.force = Eigen::Vector3d(bias[0], bias[1], bias[2]);
  params->bias.torque = Eigen::Vector3d(bias[3], bias[4], bias[5]);
}

}  // namespace

std::unique_ptr<Service> MakeVtb(Bus& bus, const Deployment& deployment,
                                 const std::string& demonstration,
                                 uint64_t seed) {
  Vtb::Params params;
  // The folder may be given with a slash at its end.
  params.task = (deployment.task_dir / "").parent_path().filename().string();
  const Task task = LoadTask(deployment);
  CheckCell(deployment.OfTask("cell.yaml"), task.parts, task.layout);
  params.parts = task.parts;
  params.layout = task.layout;
  params.demonstrations = Demonstrations::FromConfig(
      deployment.OfTask("demonstrators.yaml"), params.parts);

  const Config config = deployment.ForService("vtb");
  params.physics.dt = 1e-3 * config.Number("step_ms", 0.1, 4);
  params.physics.friction = config.Number("friction", 0, 2);
  params.physics.grip_time_constant =
      1e-3 * config.Number("grip_time_constant_ms", 2, 200);
  params.physics.sleep = config.Get<bool>("sleep");
  const double patience = config.Number("operator_patience_s", 1, 86400);
  if (!deployment.has_operator) {
    params.operator_patience = static_cast<int32_t>(patience / kTickSeconds);
  }
  params.truth_period_ticks = config.Integer("truth_period_ticks", 1, 1250);
  LoadArms(config["arms"], &params.arms);
  // Every episode has random numbers of its own.
  for (const std::string& name : demonstration.empty()
                                     ? params.demonstrations.default_episodes
                                     : SplitAtPlus(demonstration)) {
    params.episodes.push_back({name, seed + params.episodes.size()});
  }
  config.Finish();
  return std::make_unique<Vtb>(bus, params);
}

}  // namespace cell::vtb
