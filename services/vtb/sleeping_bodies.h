#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/vtb/body_contacts.h"
#include "services/vtb/collision_bounds.h"
#include "services/vtb/hands.h"
#include "services/vtb/part_bodies.h"

namespace cell::vtb {

/// Lets parts at rest sleep: they have no contacts and keep their pose bit for
/// bit.
///
/// Parts that could touch each other and parts joined by a thread are a group.
/// A group falls asleep together when all of it has been still for a while and
/// nothing moves nearby. It wakes together, before anything touches it: when
/// a hand or another part comes near, the sooner the faster it is, when one of
/// it is gripped, or when World::Place() moves one. So a part never sleeps
/// beside one that is awake, and what it rests on sleeps like itself or is
/// fixed.
class SleepingBodies {
 public:
  /// What a snapshot keeps of each part.
  struct Memory {
    int group = -1;     ///< the first part of its group; -1: awake
    int num_still = 0;  ///< steps in which it has stayed at `qpos`
    std::array<mjtNum, 7> qpos{};
    std::vector<BodyContact> contacts;  ///< of the group, at its first part
  };

  /// All must outlive this object.
  SleepingBodies(const PartTable& table, const CellLayout& layout,
                 const PartBodies& bodies, const Hands& hands, mjModel& model,
                 mjData& data, bool is_enabled);
  SleepingBodies(const SleepingBodies&) = delete;
  SleepingBodies& operator=(const SleepingBodies&) = delete;

  /// All are awake.
  void Reset();

  bool IsAsleep(size_t part) const { return memory_[part].group >= 0; }
  /// True if a step would change nothing but the time.
  bool AreAllAsleep() const;
  /// With its group.
  void Wake(size_t part);

  /// Wakes what the hands may come near to within a Run() of `duration` [s].
  void BeforeRun(double duration);
  /// Wakes what is gripped, and what parts that are awake come near to.
  void BeforeStep();
  /// Holds what sleeps in its place; lets what is still fall asleep.
  void AfterStep();

  /// Of all bodies; of those asleep, as of when they fell asleep.
  std::vector<BodyContact> Contacts() const;

  const std::vector<Memory>& memory() const { return memory_; }
  /// If it is not enabled, all are awake.
  void Restore(const std::vector<Memory>& memory);

 private:
  /// An equality that holds two parts together.
  struct Link {
    int equality;
    size_t first, second;
  };
  /// Where a box of a hand may be near a part within this Run().
  struct Approach {
    OrientedBox box;
    double distance;
  };

  bool IsMovable(size_t part) const { return bodies_[part].dof >= 0; }
  double DisplacementOf(size_t part) const;
  double SpeedBound(size_t part) const;
  bool AreNear(size_t part, size_t other) const;
  bool IsNearHand(size_t part) const;
  void CountStillSteps(size_t part);
  void TryToSleep(size_t part);
  void Sleep(const std::vector<size_t>& group);
  void Hold(size_t part);
  void SetCollides(size_t part, bool collides);

  const PartTable& table_;
  const CellLayout& layout_;
  const PartBodies& bodies_;
  const Hands& hands_;
  mjModel& model_;
  mjData& data_;
  bool is_enabled_;
  int steps_to_sleep_;
  std::vector<CollisionBounds> bounds_;  // of each part
  std::vector<Link> links_;
  std::vector<int> types_, affinities_;  // of each geom that is awake
  std::vector<Approach> approaches_;     // within this Run()
  std::vector<Memory> memory_;
};

}  // namespace cell::vtb
