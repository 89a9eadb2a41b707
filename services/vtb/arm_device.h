#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "cell/arm_setpoint_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/input_alerts.h"
#include "common/geometry/part_shape.h"
#include "common/layout/arm_layout.h"
#include "services/vtb/arm_servo.h"
#include "services/vtb/gripper.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// One arm as the cell's services meet it: ARM_SETPOINT_<ARM> in, every tick
/// ARM_STATE_<ARM> out and, if it has a sensor, WRENCH_<ARM>; ARM_STOP_<ARM>
/// says why it has stopped. In a real cell
/// a driver of the robot does the same. Simplification: the arm is as stiff as
/// its servo, nothing pushes it.
class ArmDevice {
 public:
  struct Params {
    ArmServo::Params servo;
    Gripper::Params gripper;
    /// Whether WRENCH_<ARM> is published, of an arm with a sensor.
    bool has_sensors = true;
    /// What the sensor reads with nothing on it [N, N m].
    Wrench bias;
  };

  /// All must outlive this object.
  ArmDevice(Bus& bus, const ArmLayout& layout,
            const std::vector<PartShape>& shapes, const Params& params);
  ArmDevice(const ArmDevice&) = delete;
  ArmDevice& operator=(const ArmDevice&) = delete;

  const std::string& name() const { return layout_.name; }
  /// A protective stop, for whatever reason.
  void Stop() { servo_.Stop(); }

  /// At home, with open fingers.
  void Reset(World& world);
  /// One tick of `dt` [s]: the physics are to run for as long.
  void Update(double dt, World& world);
  /// After the physics have run.
  void Publish(const World& world);

  /// True if joints and fingers stand.
  bool IsAtRest() const;
  /// Links and plinth.
  std::vector<BodyPose> Bodies() const;

 private:
  void PublishStop();
  bool OnSetpoint(const arm_setpoint_t& message);
  Eigen::Isometry3d FlangePose() const;
  Wrench Reading(const World& world, const Eigen::Isometry3d& X_WF);

  Bus& bus_;
  const ArmLayout& layout_;
  Params params_;
  InputAlerts alerts_;
  std::string suffix_;  // of its channels
  std::vector<std::string> body_names_;
  ArmServo servo_;
  Gripper gripper_;
  int num_stopped_ = 0;  // ticks since it has stopped
  int64_t stop_utime_ = 0;
  double force_ = 0;  // [N] on the tool in the tick before
  /// Of the tool's centre of mass, in the two ticks before: what it is
  /// accelerated by.
  Eigen::Vector3d p_W_tool_[2];
  double dt_ = 0;
};

}  // namespace cell::vtb
