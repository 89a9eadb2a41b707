#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cell/arm_setpoint_t.hpp"
#include "cell/arm_state_t.hpp"
#include "common/layout/arm_layout.h"
#include "services/cell/scoring/violation.h"

namespace cell::cli {

/// Whether one arm stays within its limits: of joint angles, joint speeds, what
/// can be followed from tick to tick, and its workspace.
class LimitCheck {
 public:
  struct Breach {
    Violation::Kind kind = Violation::Kind::kSpeed;
    std::string subject;  ///< what is beyond its limit, e.g. "joint 3"
    std::string value;    ///< how far, in plain words
  };

  explicit LimitCheck(const ArmLayout& arm) : arm_(arm) {}

  std::vector<Breach> OnState(const arm_state_t& state);
  /// Steps are measured between set-points of one sender.
  std::vector<Breach> OnSetpoint(const arm_setpoint_t& setpoint);
  /// An episode begins: the arm is put home.
  void Restart();
  /// How often the servos have stopped by themselves.
  int num_stops() const { return num_stops_; }

 private:
  ArmLayout arm_;
  std::optional<arm_setpoint_t> last_;
  bool is_stopped_ = false;
  int num_stops_ = 0;
};

}  // namespace cell::cli
