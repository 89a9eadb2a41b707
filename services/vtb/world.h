#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/vtb/body_contacts.h"
#include "services/vtb/hands.h"
#include "services/vtb/part_bodies.h"
#include "services/vtb/sleeping_bodies.h"
#include "services/vtb/thread_engagement.h"
#include "services/vtb/world_xml.h"

namespace cell::vtb {

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
  /// @throws std::invalid_argument for one that is fixed or articulated.
  void Place(const std::string& part, const Eigen::Isometry3d& X_WO);
  /// Puts an articulated part at a position of its joint, at rest.
  /// @throws std::invalid_argument for another one.
  void SetJoint(const std::string& part, double position);

  /// What hands do from now on.
  Hands& hands() { return *hands_; }
  const Hands& hands() const { return *hands_; }

  /// @throws std::runtime_error if the physics overflow or diverge.
  void Run(int num_steps);

  double time() const;
  Eigen::Isometry3d PoseOf(const std::string& part) const;
  /// [m/s] Of its origin; of an articulated part, of its handle.
  double SpeedOf(const std::string& part) const;
  /// [rad] or [m] Of an articulated part.
  /// @throws std::invalid_argument for another one.
  double JointOf(const std::string& part) const;
  /// True if the part is at rest, costs no contacts and keeps its pose bit for
  /// bit until something comes near.
  bool IsAsleep(const std::string& part) const;
  /// True if a thread has taken hold of the part.
  bool IsOnThread(const std::string& site, const std::string& part) const;
  /// True if a thread's last turn has been made.
  bool IsTurnedHome(const std::string& site, const std::string& part) const;
  /// Parts and the boxes of the hands, in the order of the tables.
  std::vector<BodyPose> Bodies() const;
  /// As of the last step, of parts asleep when they fell asleep; by (first,
  /// second).
  std::vector<BodyContact> Contacts() const;

  Snapshot Save() const;
  void Restore(const Snapshot& snapshot);

  const PartTable& table() const { return *table_; }
  const CellLayout& layout() const { return *layout_; }
  /// The model and its state, for benchmarks of the bare physics.
  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }

 private:
  struct ThreadJoint {
    const Site* site;
    int host, part;  // indices in the table
    int points[2], freeze;
    ThreadEngagement engagement;
  };

  const ThreadJoint* FindJoint(const std::string& site,
                               const std::string& part) const;
  int PartIndex(const std::string& part) const;
  size_t ArticulatedIndex(const std::string& part) const;
  void CheckPhysics() const;
  Eigen::Isometry3d PoseAt(int part) const;
  void Step();
  void StepThread(ThreadJoint& joint);

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
  std::unique_ptr<PartBodies> bodies_;
  std::unique_ptr<Hands> hands_;
  std::unique_ptr<SleepingBodies> sleeping_;
  std::vector<ThreadJoint> threads_;
};

struct World::Snapshot {
  std::vector<mjtNum> numbers;  ///< state of the physics
  std::vector<mjtByte> active;  ///< equalities
  std::vector<Hands::State> hands;
  std::vector<ThreadEngagement::Memory> threads;
  std::vector<SleepingBodies::Memory> sleeping;
};

}  // namespace cell::vtb
