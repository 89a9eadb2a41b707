#include "services/robot_arm/contact/straight_feed.h"

namespace cell::robot_arm {

MotionReference::Step StraightFeed::Advance(const ContactState& state,
                                            double rate, double dt) {
  UpdateTouch(state.contact.force.z(), dt);
  Step step{.R_SO = R_SO_, .is_pressing = !is_free_};
  if (is_free_) {
    const double feed = state.commanded_height > params_.touch_height
                            ? params_.free_feed
                            : params_.touch_feed;
    step.translation.z() = -(rate * feed) * dt;
  }
  return step;
}

void StraightFeed::UpdateTouch(double force, double dt) {
  if (force > params_.touch_share * params_.push) is_free_ = false;
  time_without_touch_ =
      force < params_.loose_share * params_.push ? time_without_touch_ + dt : 0;
  if (time_without_touch_ > params_.loose_time) is_free_ = true;
}

}  // namespace cell::robot_arm
