#pragma once

#include <string>

#include "services/robot_arm/contact/contact_state.h"

namespace cell::robot_arm {

/// Says when a contact motion is over, and how it has ended.
class Termination {
 public:
  enum class Outcome {
    kGoOn,
    kStuck,  ///< it has failed, unless a search helps
    kDone,
    kFailed
  };
  struct Verdict {
    Outcome outcome = Outcome::kGoOn;
    std::string reason;  ///< why it is stuck or has failed, in plain words
  };

  Termination() = default;
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;
  virtual ~Termination() = default;
  virtual Verdict Judge(const ContactState& state) const = 0;
  /// [m] along -z from `height` to where the motion shall end.
  virtual double DistanceLeft(double height) const = 0;
};

}  // namespace cell::robot_arm
