#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/parts/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/vtb/thread_engagement.h"
#include "services/vtb/world_xml.h"

namespace cell {

/// A body and where it is.
struct BodyPose {
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

/// Two bodies that touch; hands touch without pushing.
struct BodyContact {
  std::string first, second;                      ///< first < second
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< of the deepest point
  double distance = 0;                            ///< [m] negative: penetration
  double normal_force = 0;  ///< [N] sum over the pair's points
};

/// The physics of the cell (section IV): parts under gravity and contact, a
/// kinematic person's hands, grips and threads. Deterministic bit for bit.
/// Simplification: hands notice parts but do not push them, and hold a part by
/// a spring between the wrist and the whole part.
class World {
 public:
  /// All that decides the future; Restore() continues bit for bit.
  struct Snapshot;

  World(const PartTable& table, const CellLayout& layout,
        const PhysicsParams& params);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// All parts at their frames' W, hands at rest and open, time 0.
  void Reset();
  /// Puts a free part somewhere, at rest.
  void Place(const std::string& part, const Eigen::Isometry3d& X_WO);

  /// Moves the hand evenly there within the next call of Run().
  void MoveHand(const std::string& hand, const Eigen::Isometry3d& X_WG,
                double opening);
  void Grip(const std::string& hand, const std::string& part);
  void Release(const std::string& hand);
  /// Rolls the held part between the fingertips: it turns about z of G by
  /// `angle` [rad] from how it was gripped, within the next call of Run().
  void Roll(const std::string& hand, double angle);
  std::optional<std::string> HeldBy(const std::string& hand) const;

  /// @throws std::runtime_error if the physics overflow or diverge.
  void Run(int num_steps);

  double time() const;
  int num_contacts() const;
  Eigen::Isometry3d PoseOf(const std::string& part) const;
  double SpeedOf(const std::string& part) const;  ///< [m/s] of its origin
  /// True if a thread has taken hold of the part.
  bool IsOnThread(const std::string& site, const std::string& part) const;
  /// True if a thread's last turn has been made.
  bool IsTurnedHome(const std::string& site, const std::string& part) const;
  /// Parts and the boxes of the hands, in the order of the tables.
  std::vector<BodyPose> Bodies() const;
  /// As of the last step; by (first, second).
  std::vector<BodyContact> Contacts() const;

  Snapshot Save() const;
  void Restore(const Snapshot& snapshot);

  const PartTable& table() const { return *table_; }
  const CellLayout& layout() const { return *layout_; }
  /// The model and its state, for benchmarks of the bare physics.
  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }

 private:
  struct HandState {
    Eigen::Isometry3d X_WG, X_WG_goal;
    double opening, opening_goal;
    double roll, roll_goal;
    int part;                     // index of the held part; -1: none
    Eigen::Isometry3d X_GO_grip;  // when it was gripped
  };
  struct ThreadJoint {
    const Site* site;
    int host, part;  // indices in the table
    int points[2], freeze;
    ThreadEngagement engagement;
  };

  const ThreadJoint* FindJoint(const std::string& site,
                               const std::string& part) const;
  int PartIndex(const std::string& part) const;
  size_t HandIndex(const std::string& hand) const;
  bool IsHeld(int part) const;
  void CheckPhysics() const;
  Eigen::Isometry3d PoseAt(int part) const;
  void StepHand(size_t index, double fraction, double duration);
  void PutHand(size_t index, const Eigen::Isometry3d& X_WG, double opening);
  void PullGrip(size_t index, const Eigen::Isometry3d& X_WL, double roll);
  void StepThread(ThreadJoint& joint);
  void SetMocap(int mocap, const Eigen::Isometry3d& X);
  void SetWeld(int equality, int part, const Eigen::Isometry3d& X_1O);

  std::unique_ptr<PartTable> table_;
  std::unique_ptr<CellLayout> layout_;
  PhysicsParams params_;
  struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  std::vector<int> bodies_;  // of the parts
  std::vector<int> qpos_;    // address of the parts' free joints; -1: fixed
  std::vector<Eigen::Vector3d> centres_;  // of mass, in O
  std::vector<int> hand_mocaps_;          // of the wrists
  std::vector<std::vector<int>> grips_;   // equality of [hand][part]; -1: none
  std::vector<HandState> hands_;
  std::vector<ThreadJoint> threads_;
};

struct World::Snapshot {
  std::vector<mjtNum> numbers;  ///< state of the physics
  std::vector<mjtByte> active;  ///< equalities
  std::vector<HandState> hands;
  std::vector<ThreadEngagement::Memory> threads;
};

}  // namespace cell
