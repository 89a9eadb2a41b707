#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

constexpr double kRetreat = 0.10;  // [m]

class RetreatStage final : public HandStage {
 public:
  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    GoStraight(Shifted(hand.X_WG, kRetreat * hand.X_WG.linear().col(2)),
               kRetreat / (2 * hand.human_motion.insert_speed *
                           hand.Spread(context.random)),
               context);
  }
};

}  // namespace

HandAction Retreat() {
  return {std::make_shared<RetreatStage>()};
}

}  // namespace cell::vtb::hand_action
