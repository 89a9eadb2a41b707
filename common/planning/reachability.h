#pragma once

#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// Which literals a task can reach if every outcome can be chosen and whatever
/// was once true or false stays available.
class Reachability {
 public:
  explicit Reachability(const GroundTask& task);

  bool Has(const Literal& literal) const { return has_[Index(literal)]; }
  bool Has(const Conjunction& conjunction) const;
  /// True if the atom never changes.
  bool IsConstant(int atom) const {
    return !Has({atom, true}) || !Has({atom, false});
  }

 private:
  static size_t Index(const Literal& literal) {
    return 2 * static_cast<size_t>(literal.atom) + (literal.value ? 1 : 0);
  }
  bool AddEffectsOf(const GroundAction& action);

  std::vector<bool> has_;
};

/// Leaves out actions and effects that can never apply, and replaces atoms that
/// never change by their truth in all conditions.
void RemoveUnreachable(GroundTask* task);

/// Leaves out atoms that no condition, effect, or goal speaks of.
void RemoveUnusedAtoms(GroundTask* task);

}  // namespace cell::planning
