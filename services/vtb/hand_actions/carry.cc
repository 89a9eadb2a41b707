#include <numbers>

#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTableApproach = 0.03;  // [m] straight down onto the table

/// The rotation about z, among those that leave the part as it is, that brings
/// it from R_WO to the target with the least turning.
Matrix3d BestSymmetry(int order, const Matrix3d& R_WO, const Matrix3d& R_WS) {
  constexpr int kAnyAngle = 24;
  const int count = order == 0 ? kAnyAngle : order;
  Matrix3d best = Matrix3d::Identity();
  double best_angle = 10;
  for (int i = 0; i < count; ++i) {
    const Matrix3d R =
        AngleAxisd(2 * std::numbers::pi * i / count, Vector3d::UnitZ())
            .toRotationMatrix();
    const double angle = AngleBetween(R_WO, R_WS * R);
    if (angle < best_angle) {
      best_angle = angle;
      best = R;
    }
  }
  return best;
}

class CarryStage final : public HandStage {
 public:
  CarryStage(const std::string& part, const Target& target)
      : part_(part), target_(target) {}

  void Begin(HandContext& context) const override {
    Aim& aim = context.hand.aim;
    aim = target_.rule != nullptr ? AtSite(context) : OnTable(context);
    const double approach =
        target_.rule != nullptr
            ? context.world.table().FindSite(target_.site)->approach
            : kTableApproach;
    GoOver(
        Shifted(GoalOf(target_, aim, context.world), approach * aim.way_out) *
            context.hand.X_GO.inverse(),
        context);
  }
  std::optional<Eigen::Vector2d> LeadsTo(const HandState& /*hand*/,
                                         const World& world) const override {
    const Isometry3d X_WO = target_.rule != nullptr
                                ? PoseOfSite(target_.site, world)
                                : target_.X_WO;
    return X_WO.translation().head<2>();
  }

 private:
  Aim AtSite(HandContext& context) const {
    const World& world = context.world;
    const Isometry3d X_WS = PoseOfSite(target_.site, world);
    Aim aim;
    aim.symmetry = BestSymmetry(world.table().Find(part_)->symmetry_order,
                                world.PoseOf(part_).linear(), X_WS.linear());
    const double most = context.hand.human_motion.aim_error;
    std::uniform_real_distribution<double> error(-most, most);
    aim.error.x() = error(context.random);
    aim.error.y() = error(context.random);
    aim.way_out = X_WS.linear().col(2);
    return aim;
  }

  Aim OnTable(const HandContext& context) const {
    Aim aim;
    aim.X_WO_table = target_.X_WO;
    if (target_.tilt == 0) return aim;
    const Vector3d between_fingers =
        context.hand.X_GO.linear().row(0).transpose();
    aim.X_WO_table.linear() *=
        AngleAxisd(target_.tilt, between_fingers).toRotationMatrix();
    aim.X_WO_table.translation().z() -=
        context.sampler.ExtentOf(part_).Lowest(aim.X_WO_table);
    return aim;
  }

  std::string part_;
  Target target_;
};

}  // namespace

HandAction Carry(const std::string& part, const Target& target) {
  return {std::make_shared<CarryStage>(part, target)};
}

}  // namespace cell::vtb::hand_action
