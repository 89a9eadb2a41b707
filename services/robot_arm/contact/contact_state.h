#pragma once

#include "services/robot_arm/contact/contact_wrench.h"

namespace cell::robot_arm {

/// What is known of a contact motion in a tick, in the frame S of the site.
struct ContactState {
  ContactWrench contact;
  double height = 0;            ///< [m] z of the part's origin, measured
  double commanded_height = 0;  ///< [m] the same, as last commanded
  double turned = 0;            ///< [rad] about -z, as commanded so far
  bool is_stalled = false;      ///< it pushes and does not advance
};

}  // namespace cell::robot_arm
