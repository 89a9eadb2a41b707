#pragma once

#include <Eigen/Geometry>

#include "services/robot_arm/contact/contact_motion.h"
#include "services/robot_arm/contact/contact_stage.h"
#include "services/robot_arm/contact/thread_feed.h"
#include "services/robot_arm/contact/tightened_termination.h"

namespace cell::robot_arm {

/// How a part is screwed down a thread.
struct ScrewingParams {
  ThreadFeed::Params thread;
  /// The thread guides the part: it yields sideways alone, and need not slow
  /// down, since it cannot run into anything.
  ContactMotion::Params contact{.admittance = {.kp_turn = 0, .ki_turn = 0},
                                .slow_down = {.gain = 0}};
  TightenedTermination::Params tight;
  /// [rad] A thread that has held a part before may be tight earlier by this
  /// angle than by its pitch: what carries it has play.
  double early_angle = 0.5;

  /// For a part that is on its thread, `height` [m] over its seat: it needs
  /// less turning.
  ScrewingParams GoingOnAt(double height, double pitch) const;
};

/// Turns a held part, from X_SO, on a thread of `pitch` [m] per turn until it
/// is tight.
ContactMotion MakeScrewing(const ScrewingParams& params, double pitch,
                           const Eigen::Isometry3d& X_SO);

/// The same, for a stage.
ContactMotionMaker ScrewingMaker(const ScrewingParams& params, double pitch);

}  // namespace cell::robot_arm
