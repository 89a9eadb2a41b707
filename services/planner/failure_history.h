#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "common/relational/rule.h"

namespace cell::planner {

/// How often each action has failed in one and the same state. After
/// `max_attempts` it is blocked until something changes: a reason to do
/// something else, or to ask.
class FailureHistory {
 public:
  struct Entry {
    State before;
    int count = 0;
    std::string reason;  ///< of the last time, in plain words
  };

  FailureHistory(std::shared_ptr<const Vocabulary> vocabulary, int max_attempts)
      : vocabulary_(std::move(vocabulary)), max_attempts_(max_attempts) {}

  /// It was tried in `before` and has ended.
  /// Success shows in the state.
  void Add(const GroundAction& action, const State& before,
           const std::string& reason);
  /// Forgets what was tried in another state than this. What grippers hold
  /// does not count, nor what others than the action's objects can reach; an
  /// unknown atom is no change.
  void Update(const State& now);
  /// The object was moved.
  void ForgetAbout(int object);
  void Clear() { entries_.clear(); }

  std::set<GroundAction> Blocked() const;
  const std::map<GroundAction, Entry>& entries() const { return entries_; }
  /// Nullptr unless it was tried.
  const Entry* Of(const GroundAction& action) const;

 private:
  bool IsSame(const GroundAction& action, const State& before,
              const State& now) const;

  std::shared_ptr<const Vocabulary> vocabulary_;
  int max_attempts_;
  std::map<GroundAction, Entry> entries_;
};

}  // namespace cell::planner
