#pragma once

#include <optional>
#include <string>

namespace cell::robot_arm {

/// What no contact motion may exceed, however it ends.
class ContactLimits {
 public:
  struct Params {
    double force = 100;  ///< [N] no part is pushed harder
    double time = 30;    ///< [s] searches included
  };

  explicit ContactLimits(const Params& params) : params_(params) {}

  /// Why the motion must end, in plain words: the wrist sensor measures
  /// `force` [N], it has lasted `time` [s], and has `left` [m] to go.
  std::optional<std::string> WhyExceeded(double force, double time,
                                         double left) const;

 private:
  Params params_;
};

}  // namespace cell::robot_arm
