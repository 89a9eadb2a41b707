#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "services/robot_arm/contact/admittance.h"
#include "services/robot_arm/contact/contact_limits.h"
#include "services/robot_arm/contact/dither.h"
#include "services/robot_arm/contact/motion_reference.h"
#include "services/robot_arm/contact/slow_down.h"
#include "services/robot_arm/contact/spiral_search.h"
#include "services/robot_arm/contact/stall_detector.h"
#include "services/robot_arm/contact/termination.h"

namespace cell::robot_arm {

/// The motion of a held part O in contact, in the frame S of its site (section
/// VIII-B): it follows a reference, yields to external forces, slows down where
/// forces grow, searches where it is stuck, and ends by its termination. Pure:
/// a step is a function of the state, the contact and the time.
class ContactMotion {
 public:
  struct Params {
    Admittance::Params admittance;
    SlowDown::Params slow_down;
    SpiralSearch::Params search;
    Dither::Params dither;
    StallDetector::Params stall;
    ContactLimits::Params limits;
  };
  enum class State { kRunning, kDone, kFailed };

  /// Begins with the part at X_SO.
  ContactMotion(const Params& params,
                std::unique_ptr<MotionReference> reference,
                std::unique_ptr<Termination> termination,
                const Eigen::Isometry3d& X_SO);

  /// One tick of `dt` [s]. `height`: z of O in S as measured.
  State Step(const ContactWrench& contact, double height, double dt);

  /// X_SO: the commanded pose of the part.
  Eigen::Isometry3d PartPose() const;
  State state() const { return state_; }
  /// Why it has failed, in plain words.
  const std::string& reason() const { return reason_; }
  double peak_force() const { return peak_force_; }  ///< [N]

 private:
  void Fail(const std::string& reason);
  void Judge(const ContactState& now);
  void MoveOn(const ContactState& now, double dt);
  void Search(const ContactState& now, double dt);

  std::unique_ptr<MotionReference> reference_;
  std::unique_ptr<Termination> termination_;
  Admittance admittance_;
  SlowDown slow_down_;
  SpiralSearch search_;
  Dither dither_;
  StallDetector stall_;
  ContactLimits limits_;
  MotionReference::Step step_;  // the last one
  Eigen::Vector3d p_SO_;        // of the reference and of force control along z
  double time_ = 0;             // [s]
  double peak_force_ = 0;
  State state_ = State::kRunning;
  std::string reason_;
};

}  // namespace cell::robot_arm
