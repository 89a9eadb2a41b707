#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <utility>

#include "common/arms/joint_trajectory.h"
#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/motion_client.h"
#include "services/robot_arm/skill_stage.h"
#include "services/robot_arm/tool_kinematics.h"

namespace cell::robot_arm {

/// Waits for a plan of a motion and hands it on.
class AwaitPlan : public SkillStage {
 public:
  /// `client` must outlive this object.
  AwaitPlan(MotionClient& client, const MotionRequest& request,
            std::function<void(const MotionPlan&)> use)
      : inquiry_(client, request), use_(std::move(use)) {}
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  Failure failure() const override { return {inquiry_.reason()}; }

 private:
  MotionInquiry inquiry_;
  std::function<void(const MotionPlan&)> use_;
};

/// Waits for a way of the joints, and follows it.
class FollowWay : public SkillStage {
 public:
  /// `client` must outlive this object.
  FollowWay(MotionClient& client, const MotionRequest& request,
            const JointRates& rates);
  State Prepare(double dt) override;
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  std::optional<Joints> Ahead(double seconds, const Joints& q) const override;
  bool HasOtherWays() const override { return trajectory_.has_value(); }
  Failure failure() const override { return {inquiry_.reason()}; }

 private:
  MotionInquiry inquiry_;
  JointRates rates_;
  std::optional<JointTrajectory> trajectory_;
  double time_ = 0;
  double settling_ = 0;  // [s] since the trajectory's end
};

/// Moves the gripper along a straight line, turning evenly; starts and ends at
/// rest.
class MoveOnLine : public SkillStage {
 public:
  /// From where the command is when it begins. `speed` [m/s] at most.
  MoveOnLine(const ToolKinematics& kinematics, const Eigen::Isometry3d& X_WG,
             double speed);
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  std::optional<Joints> Ahead(double seconds, const Joints& q) const override;
  Failure failure() const override { return {reason_}; }

 private:
  Eigen::Isometry3d PoseAt(double time) const;

  const ToolKinematics& kinematics_;
  Eigen::Isometry3d X_WG_from_, X_WG_to_;
  double speed_;
  bool has_begun_ = false;
  double duration_ = 0, time_ = 0;
  std::string reason_;
};

/// Waits while a person's hand is in the way, for a while.
class WaitForPerson : public SkillStage {
 public:
  /// Fails if it is still in the way after `patience` [s]; 0: at once.
  WaitForPerson(std::function<bool()> is_in_the_way, double patience)
      : is_in_the_way_(std::move(is_in_the_way)), patience_(patience) {}
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  Failure failure() const override { return Failure::PersonInTheWay(); }

 private:
  std::function<bool()> is_in_the_way_;
  double patience_;
  double time_ = 0;
};

/// Opens or closes the fingers and waits for them.
class MoveFingers : public SkillStage {
 public:
  enum class Until { kThere, kGripping, kReleased };
  /// `grip`: how the fingers stand.
  MoveFingers(double opening, const std::string& grip, Until until);
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  Failure failure() const override;

 private:
  double opening_;
  std::string grip_;
  Until until_;
  double time_ = 0;
};

/// Stands still, and tares the sensor: nothing touches the part.
class Tare : public SkillStage {
 public:
  /// `sensor` must outlive this object.
  explicit Tare(ContactSensor& sensor) : sensor_(sensor) {}
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  Failure failure() const override;

 private:
  ContactSensor& sensor_;
  ArmReading::SensedWrench sum_;
  int num_ = 0;
  double time_ = 0;
};

}  // namespace cell::robot_arm
