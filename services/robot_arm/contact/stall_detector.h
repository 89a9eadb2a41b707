#pragma once

namespace cell::robot_arm {

/// Tells a part that is pushed and does not advance.
class StallDetector {
 public:
  struct Params {
    double push_share = 0.6;  ///< of the push that something must resist with
    double move = 0.0003;     ///< [m] less is no advance: grip and servos give
    double time = 0.3;        ///< [s] so long: force control has settled
  };

  /// Begins at `height` [m].
  StallDetector(const Params& params, double height)
      : params_(params), height_(height) {}

  /// One tick of `dt` [s]: the part is pushed by `push` [N] and resists by
  /// `force` [N] at `height` [m].
  void Step(double force, double push, double height, double dt);
  /// What was measured until now counts no more.
  void Reset() { stall_time_ = 0; }

  bool is_stalling() const { return stall_time_ > 0; }
  /// True if it has been for the whole time.
  bool is_stalled() const { return stall_time_ >= params_.time; }

 private:
  Params params_;
  double height_;          // where it stalls
  double stall_time_ = 0;  // [s]
};

}  // namespace cell::robot_arm
