#include "common/kinematics/arm_models.h"

#include <map>
#include <numbers>

#include "common/kinematics/ur_arm.h"

namespace cell {
namespace {

constexpr double kHalfTurn = 180;  // [deg]

// All joints turn by +-360 degrees; speeds [deg/s] of the first two, of the
// third and of the wrist.
JointLimits Limits(double shoulder, double elbow, double wrist) {
  JointLimits limits;
  limits.angle.setConstant(2 * std::numbers::pi);
  limits.speed << shoulder, shoulder, elbow, wrist, wrist, wrist;
  limits.speed = std::numbers::pi * (limits.speed / kHalfTurn);
  return limits;
}

// Lengths as the maker publishes them [m]; radii of the bases from the
// drawings of their datasheets.
std::vector<UrArm::Params> UrFamily() {
  return {
      {"ur3", 0.1519, -0.24365, -0.21325, 0.11235, 0.08535, 0.0819, 0.1198,
       0.0273, 0.064, Limits(180, 180, 360), 3},
      {"ur3e", 0.15185, -0.24355, -0.2132, 0.13105, 0.08535, 0.0921, 0.120,
       0.027, 0.064, Limits(180, 180, 360), 3},
      {"ur5", 0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823, 0.136,
       0.016, 0.075, Limits(180, 180, 180), 5},
      {"ur5e", 0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996, 0.138, 0.007,
       0.075, Limits(180, 180, 180), 5},
      {"ur10", 0.1273, -0.612, -0.5723, 0.163941, 0.1157, 0.0922, 0.221, 0.049,
       0.095, Limits(120, 180, 180), 10},
      {"ur10e", 0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655, 0.176,
       0.039, 0.095, Limits(120, 180, 180), 12.5},
      {"ur16e", 0.1807, -0.4784, -0.36, 0.17415, 0.11985, 0.11655, 0.176, 0.039,
       0.095, Limits(120, 180, 180), 16},
  };
}

using Catalogue = std::map<std::string, std::shared_ptr<const ArmModel>>;

const Catalogue& AllModels() {
  static const Catalogue models = [] {
    Catalogue made;
    for (UrArm::Params& params : UrFamily()) {
      const std::string name = params.name;
      made.emplace(name, std::make_shared<UrArm>(std::move(params)));
    }
    return made;
  }();
  return models;
}

}  // namespace

std::shared_ptr<const ArmModel> FindArmModel(const std::string& name) {
  const auto it = AllModels().find(name);
  return it == AllModels().end() ? nullptr : it->second;
}

std::vector<std::string> ArmModelNames() {
  std::vector<std::string> names;
  for (const auto& [name, model] : AllModels()) names.push_back(name);
  return names;
}

}  // namespace cell
