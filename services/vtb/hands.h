#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/vtb/body_pose.h"
#include "services/vtb/part_bodies.h"

namespace cell::vtb {

/// Force and torque that act on something [N, N m].
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
};

/// The hands of the world, persons' and grippers, in its physics: kinematic
/// boxes, and a weld by which each holds a part. A hand notices parts but does
/// not push them.
class Hands {
 public:
  /// One hand, as much of it as a snapshot keeps.
  struct State {
    Eigen::Isometry3d X_WG = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d X_WG_goal = Eigen::Isometry3d::Identity();
    size_t grip = 0;  ///< way to place the fingers
    double opening = 0, opening_goal = 0;
    double roll = 0, roll_goal = 0;
    int part = -1;  ///< index of the held part; -1: none
    Eigen::Isometry3d X_GO_grip =
        Eigen::Isometry3d::Identity();  ///< of the part when it was gripped
  };

  /// All must outlive this object.
  Hands(const PartTable& table, const CellLayout& layout,
        const PartBodies& bodies, mjModel& model, mjData& data);
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  /// At rest and open.
  void Reset();

  /// Puts an empty hand there at once.
  void Place(const std::string& hand, const Eigen::Isometry3d& X_WG,
             double opening);
  /// Moves the hand evenly there within the next call of World::Run().
  void Move(const std::string& hand, const Eigen::Isometry3d& X_WG,
            double opening);
  /// From now on the fingers stand so. @throws std::invalid_argument if the
  /// hand cannot.
  void PlaceFingers(const std::string& hand, const std::string& grip);
  void Grip(const std::string& hand, const std::string& part);
  void Release(const std::string& hand);
  /// Rolls the held part between the fingertips: it turns about z of G by
  /// `angle` [rad] from how it was gripped, within the next call of
  /// World::Run().
  void Roll(const std::string& hand, double angle);

  std::optional<std::string> HeldBy(const std::string& hand) const;
  const State& StateOf(const std::string& hand) const;
  bool IsHeld(int part) const;
  bool IsHeld(const std::string& part) const;
  /// On the hand by what it holds, in G about its origin, mean over the last
  /// call of World::Run(). Zero of a hand that holds nothing.
  Wrench WrenchOn(const std::string& hand) const;
  /// The boxes, in the order of the layout.
  std::vector<BodyPose> Bodies() const;
  /// Pose of a box in G; fingers sink a little into what they hold.
  static Eigen::Isometry3d PlaceOf(const HandType::Grip& grip, size_t box,
                                   double opening);

  /// A step of the physics is to come: `fraction` of the way through a Run()
  /// of `duration` [s].
  void BeforeStep(double fraction, double duration);
  void AfterStep();
  void BeforeRun();
  void AfterRun();

  const std::vector<State>& states() const { return states_; }
  void Restore(const std::vector<State>& states) { states_ = states; }

 private:
  struct Fixture {
    std::string name;
    const HandType* type;
    Eigen::Isometry3d X_WG_rest = Eigen::Isometry3d::Identity();
    bool is_person = false;
    int mocap = 0;           // of the wrist; the boxes follow it
    std::vector<int> grips;  // equality of each part; -1: none
    Wrench sum;              // over the steps of a Run()
    int num_steps = 0;
  };

  size_t IndexOf(const std::string& hand) const;
  void Step(size_t index, double fraction, double duration);
  void Put(size_t index, const Eigen::Isometry3d& X_WG, double opening);
  void Pull(size_t index, const Eigen::Isometry3d& X_WL, double roll);
  Wrench GripWrench(size_t index) const;
  Wrench OnFreePart(const State& state, int equality) const;
  Wrench OnArticulatedPart(const State& state, int equality) const;

  const PartTable& table_;
  mjModel& model_;
  mjData& data_;
  const PartBodies& bodies_;
  std::vector<Fixture> fixtures_;
  std::vector<State> states_;
};

}  // namespace cell::vtb
