#pragma once

#include <Eigen/Geometry>
#include <string>

namespace cell::robot_arm {

/// What touches a held part, in the axes of its site: on the part, positive.
struct ContactWrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m] about its origin
};

/// Brings a held part along the axis of a site to its seat: compliant by the
/// admittance law of section VIII-B (eq. 2, gains fixed), slowed down where
/// forces grow, searching in a spiral where it stalls. Frame S of the site:
/// the part's frame O shall come to S along -z. Pure: a step is a function of
/// the state, the contact and the time.
class Insertion {
 public:
  struct Params {
    double push = 15;            ///< [N] along -z
    double kp = 2e-5;            ///< [m/N] sideways, eq. 2
    double ki = 4e-4;            ///< [m/(N s)] all along
    double kp_turn = 2e-3;       ///< [rad/(N m)]
    double ki_turn = 0.06;       ///< [rad/(N m s)]
    double feed = 0.06;          ///< [m/s] in the air
    double touch_feed = 0.012;   ///< [m/s] where contact is to be expected
    double touch_height = 0.04;  ///< [m] from the seat: from here on
    double slow_down = 0.3;      ///< [1/N]: 1 / (1 + slow_down (F - dead))
    double slow_down_dead = 3;   ///< [N] sideways
    bool is_searching = true;
    double spiral_pitch = 0.001;   ///< [m] per turn
    double spiral_speed = 0.015;   ///< [m/s]
    double spiral_radius = 0.006;  ///< [m] at most, then from the middle again
    double yaw_dither = 0;         ///< [rad] while it is stalled
    double tilt_dither = 0;        ///< [rad]
    double end_height = 0;         ///< [m] from the seat where it is done
    double tolerance = 0.0008;     ///< [m] either way of it
    double give = 0.002;           ///< [m] the grip may yield: it seems deeper
    double timeout = 30;           ///< [s]
    double max_force = 100;        ///< [N] no part is pushed harder
  };
  enum class State { kRunning, kDone, kFailed };

  /// Begins `height` [m] above the seat, at X_SO(height).
  Insertion(const Params& params, double height);

  /// One tick of `dt` [s]. `height`: z of O in S as measured.
  State Step(const ContactWrench& contact, double height, double dt);

  /// Where the part shall be.
  Eigen::Isometry3d X_SO() const;
  State state() const { return state_; }
  /// Why it has failed, in plain words.
  const std::string& reason() const { return reason_; }
  double peak_force() const { return peak_force_; }
  bool has_searched() const { return num_spirals_ > 0; }

 private:
  void Fail(const std::string& reason);
  void MoveDown(const ContactWrench& contact, double dt);
  void Comply(const ContactWrench& contact, double dt);
  void Watch(const ContactWrench& contact, double height, double dt);
  void Search(double height, double dt);
  void Dither(double dt);

  Params params_;
  State state_ = State::kRunning;
  std::string reason_;
  double time_ = 0;
  double z_;  // [m] commanded
  bool is_in_air_ = true;
  double time_without_touch_ = 0;                     // [s]
  Eigen::Vector2d base_ = Eigen::Vector2d::Zero();    // where a search led
  Eigen::Vector2d spring_ = Eigen::Vector2d::Zero();  // proportional
  Eigen::Vector2d drift_ = Eigen::Vector2d::Zero();   // integral
  Eigen::Vector3d turn_spring_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_drift_ = Eigen::Vector3d::Zero();
  double spiral_angle_ = -1;  // [rad]; negative: no search
  double spiral_height_ = 0;  // where it began
  int num_spirals_ = 0;
  double stall_time_ = 0, stall_height_ = 0;
  double dither_ = 0;  // 0: none, to 1: all of it
  double peak_force_ = 0;
};

}  // namespace cell::robot_arm
