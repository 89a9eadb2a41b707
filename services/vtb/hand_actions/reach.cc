#include <numbers>

#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::Isometry3d;

constexpr double kApproach = 0.08;  // [m] to a handle, along z of G

class Approach final : public HandStage {
 public:
  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    GoStraight(Shifted(hand.X_WG, -kApproach * hand.X_WG.linear().col(2)),
               kApproach / (hand.human_motion.insert_speed *
                            hand.Spread(context.random)),
               context);
  }
};

class ReachStage final : public HandStage {
 public:
  explicit ReachStage(const std::string& part) : part_(part) {}

  void Begin(HandContext& context) const override {
    HandState& hand = context.hand;
    const auto& grasps = context.world.table().Find(part_)->grasps;
    const cell::Grasp& grasp = grasps[std::uniform_int_distribution<size_t>(
        0, grasps.size() - 1)(context.random)];
    hand.grasp_width = grasp.width;
    context.run.opening_to = grasp.width + 2 * hand.human_motion.open_margin;
    const Isometry3d X_WG =
        Nearer(context.world.PoseOf(part_) * grasp.X_OG, hand);
    GoOver(Shifted(X_WG, Standoff(context.world) * X_WG.linear().col(2)),
           context);
  }
  Progress Act(HandContext& context) const override {
    Progress progress = HandStage::Act(context);
    if (progress.is_done && Standoff(context.world) > 0) {
      progress.next = {std::make_shared<Approach>()};
    }
    return progress;
  }
  std::optional<Eigen::Vector2d> LeadsTo(const HandState& /*hand*/,
                                         const World& world) const override {
    const Part& part = *world.table().Find(part_);
    const Isometry3d X_WO = world.PoseOf(part_);
    return part.joint
               ? (X_WO * part.grasps.front().X_OG).translation().head<2>()
               : X_WO.translation().head<2>();
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

  double Standoff(const World& world) const {
    return world.table().Find(part_)->joint ? kApproach : 0;
  }

  std::string part_;
};

}  // namespace

HandAction Reach(const std::string& part) {
  return {std::make_shared<ReachStage>(part)};
}

}  // namespace cell::vtb::hand_action
