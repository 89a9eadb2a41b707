#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/layout/arm_layout.h"

namespace cell {

/// Finds a way for an arm through its joint space: straight, by way of one or
/// two of the postures offered, or by RRT-Connect (Kuffner and LaValle, 2000),
/// then shortened. The same question gives the same answer.
class PathPlanner {
 public:
  struct Params {
    double step = 0.04;    ///< [rad] of the fastest joint, between two looks
    double reach = 0.35;   ///< [rad] that a tree grows by
    double margin = 1.2;   ///< [rad] beyond start and goal that is searched
    int max_tries = 3000;  ///< to grow a tree
    int num_shortcuts = 60;
    uint64_t seed = 1;
  };
  using IsFree = std::function<bool(const Joints&)>;

  explicit PathPlanner(const Params& params) : params_(params) {}

  /// Waypoints from `from` to `to`, both among them; nothing if none is found.
  std::optional<std::vector<Joints>> Find(const Joints& from, const Joints& to,
                                          const std::vector<Joints>& via,
                                          const IsFree& is_free) const;

 private:
  bool IsStraightFree(const Joints& a, const Joints& b,
                      const IsFree& is_free) const;

  Params params_;
};

}  // namespace cell
