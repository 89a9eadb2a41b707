#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace cell::vtb {

/// Minimum jerk from 0 to 1 (Flash and Hogan): the profile of human reaching.
double MinimumJerk(double phase);
/// The phase at which MinimumJerk is `value`.
double MinimumJerkPhase(double value);

/// A path of a hand: minimum-jerk legs that overlap in time (a person does not
/// stop between lifting and carrying), each of them straight.
class HandPath {
 public:
  struct Speeds {
    double across = 0.4;   ///< [m/s] mean over a leg
    double along = 0.3;    ///< [m/s] up and down
    double turning = 1.5;  ///< [rad/s]
  };
  /// A path that stays at `X_WG`.
  explicit HandPath(
      const Eigen::Isometry3d& X_WG = Eigen::Isometry3d::Identity())
      : X_start_(X_WG) {}

  static HandPath Straight(const Eigen::Isometry3d& from,
                           const Eigen::Isometry3d& to, double duration);

  /// Turns evenly about an axis of W through `p_W`.
  static HandPath About(const Eigen::Isometry3d& from,
                        const Eigen::Vector3d& p_W, const Eigen::Vector3d& axis,
                        double angle, double duration);

  /// Up, across and down; it moves across and turns only above `clear_z`.
  /// `bend` [m] curves the way across to the left.
  static HandPath Over(const Eigen::Isometry3d& from,
                       const Eigen::Isometry3d& to, double clear_z,
                       double top_z, double bend, const Speeds& speeds);

  double duration() const { return duration_; }
  Eigen::Isometry3d At(double time) const;

 private:
  struct Leg {
    double start, duration;
    Eigen::Vector3d delta;
    Eigen::Vector3d bend;
  };
  void Add(const Leg& leg);
  void Turn(double start, double duration, const Eigen::Isometry3d& to);

  Eigen::Isometry3d X_start_;
  std::vector<Leg> legs_;
  double turn_start_ = 0, turn_duration_ = 0;
  Eigen::Vector3d turn_ = Eigen::Vector3d::Zero();  // rotation vector in W
  struct Arc {
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double angle = 0;  // [rad] in the whole duration
  };
  Arc arc_;
  double duration_ = 0;
};

}  // namespace cell::vtb
