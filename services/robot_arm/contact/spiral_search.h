#pragma once

#include <Eigen/Core>

namespace cell::robot_arm {

/// Ever wider circles across the axis of a site until the part sinks in. Where
/// it did becomes the middle.
class SpiralSearch {
 public:
  struct Params {
    double pitch = 0.001;   ///< [m] per turn: as a hole's play
    double speed = 0.015;   ///< [m/s] along the spiral: it can sink in passing
    double radius = 0.006;  ///< [m] at most, then back to the middle
    double found = 0.0007;  ///< [m] that it sinks: more than a stalled part
    int max_spirals = 4;    ///< then there is no way in; 0: no search
  };
  enum class State { kIdle, kSearching, kFound, kExhausted };

  explicit SpiralSearch(const Params& params) : params_(params) {}

  bool is_enabled() const { return params_.max_spirals > 0; }
  bool is_searching() const { return angle_ >= 0; }
  /// From `height` [m]; goes on if it searches already.
  void Begin(double height);
  /// One tick of `dt` [s] at `height` [m].
  State Step(double height, double dt);

  /// [m] across the axis: what was found, and the circles about it.
  const Eigen::Vector2d& middle() const { return middle_; }
  Eigen::Vector2d Circle() const;
  int max_spirals() const { return params_.max_spirals; }

 private:
  void GoOn(double way);

  Params params_;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  double angle_ = -1;  // [rad]; negative: it does not search
  double radius_ = 0;  // [m]
  bool is_returning_ = false;
  double height_ = 0;  // where it began
  int num_spirals_ = 0;
};

}  // namespace cell::robot_arm
