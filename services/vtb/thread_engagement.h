#pragma once

#include <Eigen/Geometry>

#include "common/parts/part_table.h"

namespace cell::vtb {

/// What a thread does to a part near its site, from their poses alone. The
/// physics hold the part on the axis at the height that `remaining` says.
class ThreadEngagement {
 public:
  enum class State {
    kOpen,     ///< the thread has not taken hold
    kEngaged,  ///< the part turns and advances
    kFrozen    ///< nobody turns it, or it is seated: friction holds it
  };
  /// All that a snapshot must keep.
  struct Memory {
    State state = State::kOpen;
    double remaining = 0;  ///< [m] along z of S from the seat
    double angle = 0;      ///< [rad] of the part about z of S
    bool was_held = false;
  };

  explicit ThreadEngagement(const Thread& thread) : thread_(thread) {}

  /// One step. X_SO: pose of the part in the site's frame.
  void Update(const Eigen::Isometry3d& X_SO, bool is_held);

  const Memory& memory() const { return memory_; }
  void Restore(const Memory& memory) { memory_ = memory; }
  /// Where the thread holds the part.
  Eigen::Isometry3d X_SO() const;

 private:
  bool TakesHold(const Eigen::Isometry3d& X_SO) const;

  Thread thread_;
  Memory memory_;
};

}  // namespace cell::vtb
