#include <numbers>

#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::Isometry3d;

class ReachStage final : public HandStage {
 public:
  explicit ReachStage(const std::string& part) : part_(part) {}

  void Begin(HandContext& context) const override {
    HandState& hand = context.hand;
    const auto& grasps = context.world.table().Find(part_)->grasps;
    const cell::Grasp& grasp = grasps[std::uniform_int_distribution<size_t>(
        0, grasps.size() - 1)(context.random)];
    hand.grasp_width = grasp.width;
    context.run.opening_to = grasp.width + 2 * hand.manner.open_margin;
    GoOver(Nearer(context.world.PoseOf(part_) * grasp.X_OG, hand), context);
  }
  std::optional<Eigen::Vector2d> LeadsTo(const HandState& /*hand*/,
                                         const World& world) const override {
    return world.PoseOf(part_).translation().head<2>();
  }

 private:
  // Thumb and fingers may change sides.
  static Isometry3d Nearer(const Isometry3d& X_WG, const HandState& hand) {
    const Isometry3d flipped =
        X_WG * Isometry3d(Eigen::AngleAxisd(std::numbers::pi,
                                            Eigen::Vector3d::UnitZ()));
    const bool is_nearer = AngleBetween(hand.X_WG.linear(), flipped.linear()) <
                           AngleBetween(hand.X_WG.linear(), X_WG.linear());
    return is_nearer ? flipped : X_WG;
  }

  std::string part_;
};

}  // namespace

HandAction Reach(const std::string& part) {
  return {std::make_shared<ReachStage>(part)};
}

}  // namespace cell::vtb::hand_action
