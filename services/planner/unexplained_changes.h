#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/relational/domain.h"
#include "services/planner/observations.h"

namespace cell::planner {

/// Changes of the state that no recognised action accounts for: the recognizer
/// was dead meanwhile, or it happened by itself. The plan is right
/// nevertheless, since it is made from the state.
///
/// An atom of the task's goals is accounted for only by an action with an
/// object of it; the others, like those of what lies below a part in the air,
/// by any action at that time. After a late start the actions before are not
/// known: atoms of the goals that are true already have to be accounted for,
/// too.
class UnexplainedChanges {
 public:
  struct Params {
    /// [us] An action has a name by then: it ends when the hand lets go.
    int64_t patience_us = 15'000'000;
    /// [us] A change so long after an action's end is its doing.
    int64_t settle_us = 2'000'000;
  };

  /// What is true in the first state was so when the episode began, unless
  /// `has_joined_late`.
  UnexplainedChanges(std::shared_ptr<const Vocabulary> vocabulary,
                     std::span<const Goal> goals, const Params& params,
                     bool has_joined_late = false);

  void Update(const SensedState& sensed);
  void Update(const DoneAction& action);

  bool has_joined_late() const { return has_joined_late_; }
  bool has_state() const { return latest_.has_value(); }

  /// What has waited long enough for an action, in plain words, once.
  std::vector<std::string> TakeOverdue(int64_t now);
  /// All changes that still wait: the episode is over.
  std::vector<std::string> TakeAll();

 private:
  struct Change {
    int64_t key_frame = 0;
    int64_t utime = 0;
    std::vector<std::pair<int, bool>> atoms;  // and what they have become
    bool is_found = false;  // of unknown age: true in the first state
  };

  Change Found(const SensedState& sensed) const;
  Change ChangesSince(const SensedState& sensed);
  void Add(Change change);
  bool IsDuring(const DoneAction& action, const Change& change) const;
  bool Explains(const DoneAction& action, int atom) const;
  /// Takes away what the action explains.
  void Account(const DoneAction& action, Change& change) const;
  std::string Describe(const Change& change) const;

  std::shared_ptr<const Vocabulary> vocabulary_;
  Params params_;
  bool has_joined_late_;
  std::set<int> goal_predicates_;
  std::optional<SensedState> latest_;
  std::vector<Change> changes_;     // not accounted for yet
  std::deque<DoneAction> actions_;  // the latest ones
};

}  // namespace cell::planner
