#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

class PauseStage final : public HandStage {
 public:
  explicit PauseStage(double duration) : duration_(duration) {}

  Progress Act(HandContext& context) const override {
    return {context.run.time >= duration_};
  }

 private:
  double duration_;
};

}  // namespace

HandAction Pause(double duration) {
  return {std::make_shared<PauseStage>(duration)};
}

}  // namespace cell::vtb::hand_action
