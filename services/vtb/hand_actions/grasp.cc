#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

class CloseFingers final : public HandStage {
 public:
  explicit CloseFingers(const std::string& part) : part_(part) {}

  void Begin(HandContext& context) const override {
    context.run.opening_to = context.hand.grasp_width;
  }
  Progress Act(HandContext& context) const override {
    HandState& hand = context.hand;
    if (!Follow(context, hand.human_motion.close_time)) return {};
    Hands& hands = context.world.hands();
    if (hands.IsHeld(part_)) {  // somebody else was quicker
      HandAction next = Retreat();
      for (const auto& stage : Rest()) next.push_back(stage);
      return {.is_done = true, .next = next, .is_all_dropped = true};
    }
    hands.Grip(hand.name, part_);
    hand.X_GO = hand.X_WG.inverse() * context.world.PoseOf(part_);
    hand.num_tries = 0;
    return {.is_done = true};
  }

 private:
  std::string part_;
};

class Dwell final : public HandStage {
 public:
  Progress Act(HandContext& context) const override {
    return {context.run.time >= context.hand.human_motion.dwell};
  }
};

}  // namespace

HandAction Grasp(const std::string& part) {
  return {std::make_shared<CloseFingers>(part), std::make_shared<Dwell>()};
}

}  // namespace cell::vtb::hand_action
