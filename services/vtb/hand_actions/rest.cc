#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

constexpr double kRestOpening = 0.03;  // [m] between empty fingers

class RestStage final : public HandStage {
 public:
  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    GoOver(hand.X_WG_rest, context);
    if (!context.world.hands().HeldBy(hand.name)) {
      context.run.opening_to = kRestOpening;
    }
  }
  std::optional<Eigen::Vector2d> LeadsTo(
      const HandState& hand, const World& /*world*/) const override {
    return hand.X_WG_rest.translation().head<2>();
  }
};

}  // namespace

HandAction Rest() {
  return {std::make_shared<RestStage>()};
}

}  // namespace cell::vtb::hand_action
