#pragma once

#include "services/robot_arm/contact/termination.h"

namespace cell::robot_arm {

/// Done when a thread is tight, by its torque: what carries the thread may
/// shift a little, so its height does not show it.
class TightenedTermination : public Termination {
 public:
  struct Params {
    double torque = 0.4;     ///< [N m] about z: it is tight
    double min_angle = 4.5;  ///< [rad] tight before that: it has jammed
    double max_angle = 8.4;  ///< [rad] after that: the thread does not hold
  };

  explicit TightenedTermination(const Params& params) : params_(params) {}
  Verdict Judge(const ContactState& state) const override;
  double DistanceLeft(double height) const override { return height; }

 private:
  Params params_;
};

}  // namespace cell::robot_arm
