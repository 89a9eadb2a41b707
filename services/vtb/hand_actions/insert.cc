#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/predicates/seat.h"
#include "services/vtb/hand_actions.h"

namespace cell::vtb::hand_action {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kTablePress = 0.001;   // [m] beyond the table
constexpr double kThreadPush = 0.0015;  // [m] onto a thread, before turning
constexpr double kRaise = 0.03;         // [m] before another try
constexpr double kRaiseTime = 1.0;      // [s]
constexpr double kFirstLook = 0.1;      // [s] after lowering
constexpr double kStill = 0.005;        // [m/s]
constexpr int kMaxTries = 4;

// The search of a person who feels that it does not go in.
constexpr double kSearchAfter = 0.4;    // [s]
constexpr double kSearchTime = 5;       // [s] before it raises the part
constexpr double kSearchTurns = 1.2;    // [1/s]
constexpr double kSearchSpread = 8e-4;  // [m/s]
constexpr double kSearchRadius = 3e-3;  // [m] at most
constexpr double kSearchTwist = 0.02;   // [rad]

bool IsAtTarget(const std::string& part, const Target& target,
                const World& world) {
  if (world.SpeedOf(part) > kStill) return false;
  const PlacementRule* rule = target.rule;
  if (rule == nullptr) return true;
  if (!IsMeantFor(part, target.site, world)) return false;
  if (ThreadOf(target.site, world) != nullptr) {
    return world.IsOnThread(target.site, part);
  }
  const Isometry3d X_SO =
      PoseOfSite(target.site, world).inverse() * world.PoseOf(part);
  // However it is turned: that is chosen before.
  return IsSeated(X_SO, 0, rule->seated);
}

/// Along the way in, and presses.
class Lower final : public HandStage {
 public:
  explicit Lower(const Target& target) : target_(target) {}

  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    const Isometry3d X_WG = Shifted(GoalOf(target_, hand.aim, context.world),
                                    -Beyond(context.world) * hand.aim.way_out) *
                            hand.X_GO.inverse();
    const double way = (X_WG.translation() - hand.X_WG.translation()).norm();
    GoStraight(
        X_WG,
        way / (hand.human_motion.insert_speed * hand.Spread(context.random)),
        context);
  }

 private:
  double Beyond(const World& world) const {
    if (target_.rule == nullptr) return kTablePress;
    const Thread* thread = ThreadOf(target_.site, world);
    return thread != nullptr ? kThreadPush - thread->engagement
                             : target_.rule->press;
  }

  Target target_;
};

/// For another try.
class Raise final : public HandStage {
 public:
  void Begin(HandContext& context) const override {
    const HandState& hand = context.hand;
    GoStraight(Shifted(hand.X_WG, kRaise * hand.aim.way_out), kRaiseTime,
               context);
  }
};

/// Until it is seated.
class Settle final : public HandStage {
 public:
  Settle(const std::string& part, const Target& target)
      : part_(part), target_(target) {}

  Progress Act(HandContext& context) const override {
    const double time = context.run.time;
    if (time >= kFirstLook && IsAtTarget(part_, target_, context.world)) {
      return {.is_done = true};
    }
    if (time > kSearchTime) return TryAgain(context.hand);
    if (time >= kSearchAfter) Search(time - kSearchAfter, context);
    return {};
  }

 private:
  /// Ever wider circles about the way in, with a little twist.
  static void Search(double time, HandContext& context) {
    HandState& hand = context.hand;
    const Vector3d& way_out = hand.aim.way_out;
    const double radius = std::min(kSearchSpread * time, kSearchRadius);
    const double angle = 2 * std::numbers::pi * kSearchTurns * time;
    const auto R =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), way_out);
    hand.X_WG = Shifted(
        context.run.path.At(0),
        R * Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0));
    hand.X_WG.linear() =
        AngleAxisd(kSearchTwist * std::sin(0.7 * angle), way_out) *
        hand.X_WG.linear();
  }

  Progress TryAgain(HandState& hand) const {
    if (target_.X_WO_else) return GiveUp();
    if (++hand.num_tries >= kMaxTries) {
      hand.failures.push_back(part_);
      return {.is_done = true};
    }
    HandAction again = Insert(part_, target_);
    again.insert(again.begin(), std::make_shared<Raise>());
    return {.is_done = true, .next = again};
  }

  Progress GiveUp() const {
    const Target back{nullptr, "", *target_.X_WO_else};
    HandAction away;
    for (const HandAction& action :
         {Extract(target_.site), Carry(part_, back), Insert(part_, back),
          Release(part_), Retreat(), Rest()}) {
      away.insert(away.end(), action.begin(), action.end());
    }
    return {.is_done = true, .next = away, .is_all_dropped = true};
  }

  std::string part_;
  Target target_;
};

}  // namespace

HandAction Insert(const std::string& part, const Target& target) {
  return {std::make_shared<Lower>(target),
          std::make_shared<Settle>(part, target)};
}

}  // namespace cell::vtb::hand_action
