#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "services/robot_arm/arm_reading.h"
#include "services/robot_arm/contact/contact_wrench.h"
#include "services/robot_arm/tool_kinematics.h"

namespace cell::robot_arm {

/// What touches the held part, from what the wrist sensor reads: without the
/// weights and the inertia of tool and part, smoothed, and without the offset
/// that was tared. Without these the tool's own inertia, fed back by force
/// control, would shake the arm.
class ContactSensor {
 public:
  struct Params {
    double cutoff = 12;      ///< [Hz] of the smoothing: half the servos' own
    double patience = 0.05;  ///< [s] without a reading, of a motion in contact
  };

  /// `kinematics` must outlive this object.
  ContactSensor(const ToolKinematics& kinematics, const ArmLayout& layout,
                const Params& params);
  ContactSensor(const ContactSensor&) = delete;
  ContactSensor& operator=(const ContactSensor&) = delete;

  /// A part of `mass` [kg] is held with its centre of mass at p_G.
  void Load(double mass, const Eigen::Vector3d& p_G);
  void Unload() { bodies_[1].mass = 0; }
  /// To be called once a tick of `dt` [s].
  void Update(const ArmReading& reading, double dt);

  /// In S, smoothed, with the offset still in it. Nothing if the sensor has
  /// been silent in this tick.
  const std::optional<ArmReading::SensedWrench>& weightless() const {
    return weightless_;
  }
  /// With nothing touching the part, the mean of weightless() is this.
  void SetOffset(const ArmReading::SensedWrench& offset) { offset_ = offset; }

  const Params& params() const { return params_; }

  /// On the part, about the point p_W, in axes that R_WA turns into W's.
  /// @pre weightless().
  ContactWrench ContactAt(const Eigen::Vector3d& p_W,
                          const Eigen::Matrix3d& R_WA) const;

 private:
  struct Body {
    double mass = 0;
    Eigen::Vector3d p_F = Eigen::Vector3d::Zero();
    /// Where its centre of mass was in the ticks before.
    std::optional<Eigen::Vector3d> p_W[2];
  };
  Eigen::Vector3d ForceOn(Body& body, const Eigen::Vector3d& p_W, double dt);

  const ToolKinematics& kinematics_;
  Params params_;
  Eigen::Isometry3d X_FG_;
  Body bodies_[2];  // tool and part
  Eigen::Isometry3d X_WS_ = Eigen::Isometry3d::Identity();
  std::optional<ArmReading::SensedWrench> weightless_, smooth_;
  ArmReading::SensedWrench offset_;
};

}  // namespace cell::robot_arm
