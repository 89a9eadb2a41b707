#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kTurnTime = 20;  // [s] at most

class TurnStage final : public HandStage {
 public:
  TurnStage(const std::string& part, const Target& target)
      : part_(part), target_(target) {}

  Progress Act(HandContext& context) const override {
    World& world = context.world;
    HandState& hand = context.hand;
    if (target_.rule == nullptr || ThreadOf(target_.site, world) == nullptr ||
        world.IsTurnedHome(target_.site, part_)) {
      return {.is_done = true};
    }
    if (context.run.time > kTurnTime) {
      hand.failures.push_back(part_);
      return {.is_done = true};
    }
    hand.roll -= hand.human_motion.turn_rate * context.dt;
    world.hands().Roll(hand.name, hand.roll);
    // The hand goes with the part along its axis.
    const Isometry3d X_WS = PoseOfSite(target_.site, world);
    const double z = (X_WS.inverse() * world.PoseOf(part_).translation()).z();
    hand.X_WG.translation() =
        X_WS * Vector3d(0, 0, z) - hand.X_WG.linear() * hand.X_GO.translation();
    return {};
  }

 private:
  std::string part_;
  Target target_;
};

}  // namespace

HandAction Turn(const std::string& part, const Target& target) {
  return {std::make_shared<TurnStage>(part, target)};
}

}  // namespace cell::vtb::hand_action
