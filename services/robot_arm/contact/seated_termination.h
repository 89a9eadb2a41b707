#pragma once

#include "services/robot_arm/contact/termination.h"

namespace cell::robot_arm {

/// Done where a part stalls near its seat; where it stalls elsewhere it is
/// stuck.
class SeatedTermination : public Termination {
 public:
  struct Params {
    double height = 0;          ///< [m] over the seat, where it shall end
    double tolerance = 0.0008;  ///< [m] up or down: accuracy of tracks
    double give = 0.002;        ///< [m] deeper, as the grip yields to the push
  };

  explicit SeatedTermination(const Params& params) : params_(params) {}
  Verdict Judge(const ContactState& state) const override;
  double DistanceLeft(double height) const override {
    return height - params_.height;
  }

 private:
  Params params_;
};

}  // namespace cell::robot_arm
