#include "services/vtb/hand_actions/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cell::vtb::hand_action {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// How far the hand goes beyond the limit, at which the part stops, and how near
// to it is there. At the handle.
constexpr double kBeyond = 0.004, kNear = 0.002;  // [m]
constexpr double kShortest = 0.5;                 // [s]
constexpr double kPatience = 1;                   // [s] at the end of the way

const char* NameOf(PartJoint::Kind kind) {
  return kind == PartJoint::Kind::kHinge ? "hinge" : "slide";
}

class ToLimitStage final : public HandStage {
 public:
  ToLimitStage(const std::string& part, PartJoint::Kind kind, bool is_upper)
      : part_(part), kind_(kind), is_upper_(is_upper) {}

  void Begin(HandContext& context) const override {
    const Part& part = *context.world.table().Find(part_);
    if (!part.joint || part.joint->kind != kind_) {
      throw std::invalid_argument(part_ + " is on no " + NameOf(kind_));
    }
    const double from = context.world.JointOf(part_);
    const double beyond = (is_upper_ ? 1 : -1) * kBeyond / LeverOf(part);
    const double way = Limit(*part.joint) + beyond - from;
    const HandState& hand = context.hand;
    const double speed =
        hand.human_motion.speeds.along * hand.Spread(context.random);
    const double duration =
        std::max(kShortest, std::abs(way) * LeverOf(part) / speed);
    context.run.path = PathOf(*part.joint, way, duration, context);
  }

  Progress Act(HandContext& context) const override {
    if (!Follow(context, context.run.path.duration())) return {};
    const Part& part = *context.world.table().Find(part_);
    const double left = (is_upper_ ? 1 : -1) *
                        (Limit(*part.joint) - context.world.JointOf(part_));
    if (left * LeverOf(part) < kNear) return {.is_done = true};
    if (context.run.time < context.run.path.duration() + kPatience) return {};
    context.hand.failures.push_back(part_);
    return {.is_done = true};
  }

 private:
  double Limit(const PartJoint& joint) const {
    return is_upper_ ? joint.upper : joint.lower;
  }

  /// [m] that the handle moves per unit of the joint.
  static double LeverOf(const Part& part) {
    return part.joint->LeverAt(part.grasps.front().X_OG.translation());
  }

  HandPath PathOf(const PartJoint& joint, double way, double duration,
                  const HandContext& context) const {
    const Isometry3d& X_WG = context.hand.X_WG;
    const Isometry3d X_WO = context.world.PoseOf(part_);
    const Vector3d axis = X_WO.linear() * joint.axis;
    if (joint.kind == PartJoint::Kind::kHinge) {
      return HandPath::About(X_WG, X_WO * joint.p_OA, axis, way, duration);
    }
    return HandPath::Straight(X_WG, Shifted(X_WG, way * axis), duration);
  }

  std::string part_;
  PartJoint::Kind kind_;
  bool is_upper_;
};

}  // namespace

HandAction ToLimit(const std::string& part, PartJoint::Kind kind,
                   bool is_upper) {
  return {std::make_shared<ToLimitStage>(part, kind, is_upper)};
}

}  // namespace cell::vtb::hand_action
