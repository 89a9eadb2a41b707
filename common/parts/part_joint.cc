#include "common/parts/part_joint.h"

#include <vector>

#include "common/geometry/degree.h"
#include "common/parts/piece_config.h"

namespace cell {
namespace {

using Eigen::Vector3d;

constexpr double kMaxTurn = 360;  // [deg]
constexpr double kMost = 1e4;     // of friction and damping

PartJoint::Kind KindFromConfig(const Config& config) {
  const auto kind = config.Get<std::string>("kind");
  if (kind == "hinge") return PartJoint::Kind::kHinge;
  if (kind == "slide") return PartJoint::Kind::kSlide;
  config["kind"].Fail("'" + kind + "' is neither hinge nor slide");
}

void ReadLimits(const Config& config, PartJoint* joint) {
  const bool is_hinge = joint->kind == PartJoint::Kind::kHinge;
  const std::string key = is_hinge ? "limits_deg" : "limits_mm";
  if (!config.Has(key)) {
    config.Fail("a " + std::string(is_hinge ? "hinge" : "slide") + " needs " +
                key + ": [lower, upper]");
  }
  const std::vector<double> limits = config.Numbers(key, 2);
  const double most = is_hinge ? kMaxTurn : kMaxLength;
  if (!(limits[0] < limits[1] && limits[0] >= -most && limits[1] <= most)) {
    config[key].Fail("should be [lower, upper], ascending, within " +
                     std::to_string(static_cast<int>(most)));
  }
  if (!(limits[0] <= 0 && limits[1] >= 0)) {
    config[key].Fail("should contain 0, where the part is at the start");
  }
  const double unit = is_hinge ? kDegree : kMm;
  joint->lower = unit * limits[0];
  joint->upper = unit * limits[1];
}

Vector3d AxisFromConfig(const Config& config) {
  const std::vector<double> xyz = config.Numbers("axis", 3);
  const Vector3d axis(xyz[0], xyz[1], xyz[2]);
  if (!(axis.norm() > 1e-6)) config["axis"].Fail("has no direction");
  return axis.normalized();
}

}  // namespace

PartJoint PartJoint::FromConfig(const Config& config) {
  PartJoint joint;
  joint.kind = KindFromConfig(config);
  joint.host = config.Get<std::string>("on");
  joint.X_HO_zero = PoseInMm(config);
  joint.axis = AxisFromConfig(config);
  if (joint.kind == Kind::kHinge) {
    const std::vector<double> at = config.Numbers("at", 3);
    joint.p_OA = kMm * Vector3d(at[0], at[1], at[2]);
  }
  ReadLimits(config, &joint);
  joint.friction = config.Number("friction", 0, kMost);
  joint.damping = config.Number("damping", 0, kMost);
  return joint;
}

Eigen::Isometry3d PartJoint::Displacement(double position) const {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (kind == Kind::kSlide) {
    X.translation() = position * axis;
    return X;
  }
  X.linear() = Eigen::AngleAxisd(position, axis).toRotationMatrix();
  X.translation() = p_OA - X.linear() * p_OA;
  return X;
}

double PartJoint::LeverAt(const Vector3d& p_O) const {
  return kind == Kind::kSlide ? 1 : axis.cross(p_O - p_OA).norm();
}

}  // namespace cell
