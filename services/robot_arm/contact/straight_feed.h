#pragma once

#include <Eigen/Core>

#include "services/robot_arm/contact/motion_reference.h"

namespace cell::robot_arm {

/// Straight down the axis of the site: at a feed until there is contact, then
/// by force alone.
class StraightFeed : public MotionReference {
 public:
  struct Params {
    double push = 15;            ///< [N] along -z: beyond the friction of a fit
    double free_feed = 0.06;     ///< [m/s] where nothing is expected
    double touch_feed = 0.012;   ///< [m/s] where contact is: a soft first peak
    double touch_height = 0.04;  ///< [m] from the seat: contact from here on
    /// Of the push. Contact begins above the one; it is over after the time
    /// [s] below the other, so that a bounce does not count.
    double touch_share = 0.3;
    double loose_share = 0.1;
    double loose_time = 0.2;
  };

  /// The part keeps its orientation R_SO.
  explicit StraightFeed(const Params& params, const Eigen::Matrix3d& R_SO =
                                                  Eigen::Matrix3d::Identity())
      : params_(params), R_SO_(R_SO) {}

  Step Advance(const ContactState& state, double rate, double dt) override;
  double push() const override { return params_.push; }

 private:
  void UpdateTouch(double force, double dt);

  Params params_;
  Eigen::Matrix3d R_SO_;
  bool is_free_ = true;
  double time_without_touch_ = 0;  // [s]
};

}  // namespace cell::robot_arm
