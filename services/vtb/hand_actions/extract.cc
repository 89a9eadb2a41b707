#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

class ExtractStage final : public HandStage {
 public:
  explicit ExtractStage(const std::string& site) : site_(site) {}

  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    const double way = context.world.table().FindSite(site_)->approach;
    const Eigen::Vector3d way_out =
        PoseOfSite(site_, context.world).linear().col(2);
    GoStraight(
        Shifted(hand.X_WG, way * way_out),
        way / (hand.human_motion.insert_speed * hand.Spread(context.random)),
        context);
  }

 private:
  std::string site_;
};

}  // namespace

HandAction Extract(const std::string& site) {
  return {std::make_shared<ExtractStage>(site)};
}

}  // namespace cell::vtb::hand_action
