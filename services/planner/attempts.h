#pragma once

#include <map>
#include <set>
#include <string>

#include "common/relational/domain.h"

namespace cell::planner {

/// How often an action was tried in vain in one and the same state. After so
/// many times it is blocked until something changes: a reason to do something
/// else, or to ask.
class Attempts {
 public:
  struct Entry {
    State before;
    int count = 0;
    std::string reason;  ///< of the last time, in plain words
  };

  /// `domain` must outlive this object.
  Attempts(const Domain& domain, int max_attempts)
      : domain_(domain), max_attempts_(max_attempts) {}

  /// It was tried in `before` and has ended. If it has succeeded, the state
  /// will tell.
  void Add(const GroundAction& action, const State& before,
           const std::string& reason);
  /// Forgets what was tried in another state than this. What grippers hold
  /// does not count, nor what others than the action's objects can reach; an
  /// unknown atom is no change.
  void Update(const State& now);
  /// Somebody has moved the object.
  void ForgetAbout(int object);
  void Clear() { entries_.clear(); }

  std::set<GroundAction> Blocked() const;
  /// Nothing unless it was tried.
  const Entry* Of(const GroundAction& action) const;

 private:
  bool IsSame(const GroundAction& action, const State& before,
              const State& now) const;

  const Domain& domain_;
  int max_attempts_;
  std::map<GroundAction, Entry> entries_;
};

}  // namespace cell::planner
