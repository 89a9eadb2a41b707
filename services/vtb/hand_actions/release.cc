#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;

constexpr double kRelaxTime = 0.2;  // [s] until no force is left

/// No force before letting go.
class Relax final : public HandStage {
 public:
  explicit Relax(const std::string& part) : part_(part) {}

  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    const Isometry3d X_GO =
        Isometry3d(AngleAxisd(hand.roll, Eigen::Vector3d::UnitZ())) * hand.X_GO;
    GoStraight(context.world.PoseOf(part_) * X_GO.inverse(), kRelaxTime,
               context);
  }
  Progress Act(HandContext& context) const override {
    return {Follow(context, context.run.path.duration() +
                                context.hand.human_motion.dwell)};
  }

 private:
  std::string part_;
};

class OpenFingers final : public HandStage {
 public:
  void Begin(HandContext& context) const override {
    HandState& hand = context.hand;
    context.world.hands().Release(hand.name);
    hand.roll = 0;
    context.run.opening_to =
        hand.grasp_width + 2 * hand.human_motion.open_margin;
  }
  Progress Act(HandContext& context) const override {
    return {Follow(context, context.hand.human_motion.close_time)};
  }
};

}  // namespace

HandAction Release(const std::string& part) {
  return {std::make_shared<Relax>(part), std::make_shared<OpenFingers>()};
}

}  // namespace cell::vtb::hand_action
