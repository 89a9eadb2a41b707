#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/planner/plan_search.h"

namespace cell::planner {

/// What was sensed at a key frame.
struct SensedState {
  int64_t key_frame = 0;
  int64_t utime = 0;  ///< [us]
  State state;
};

/// A manipulation that was recognised.
struct DoneAction {
  int64_t index = 0;  ///< names it
  int64_t utime = 0;  ///< [us] of the placement
  int64_t pick_key_frame = 0;
  int64_t place_key_frame = 0;
  std::vector<int> objects;  ///< that it concerned
  std::string text;          ///< "Insert(bolt_1, frame.hole_1)"
  int64_t pick_utime = 0;    ///< [us]
};

struct Alert {
  enum class Cause { kLongerPlan, kNoPlan };
  Cause cause;
  int64_t utime = 0;  ///< [us] of the action
  std::string text;
};

/// Watches somebody do a task (section VII-C): after each action there must be
/// a way to the goal, and it must not have become longer by the action. Pairs
/// actions with the state at their key frame, whichever comes first.
class Monitor {
 public:
  struct Params {
    /// An action that makes the way longer by more than so many expected
    /// actions is a deviation; the least true one is 1.
    double min_detour = 0.5;
    /// States and actions that are remembered: of the latest key frames. An
    /// action that lasts longer is compared with the oldest one.
    int max_remembered = 1024;
  };
  struct PlanOfState {
    int64_t key_frame = 0;
    int64_t utime = 0;
    Plan plan;
  };
  struct Report {
    std::optional<PlanOfState> plan;  ///< if there is one to tell
    std::vector<Alert> alerts;        ///< at most one per action, ever
  };

  Monitor(PlanSearch search, const Params& params);

  /// A plan is told for the first state, after an action, and when it changes.
  Report Take(const SensedState& sensed);
  Report Take(const DoneAction& action);

  const PlanSearch& search() const { return search_; }

 private:
  /// Judges the action by the state after it. While that is undecided the
  /// action waits for one that is not.
  std::optional<Alert> Judge(const DoneAction& action,
                             const SensedState& after);
  /// Expected actions to the goal had the action not been made.
  std::optional<double> ActionsWithout(const DoneAction& action,
                                       const State& after);
  std::vector<Alert> JudgeDeferred(const SensedState& after);
  void Forget();
  Report Tell(std::vector<Alert> alerts, bool has_acted);

  PlanSearch search_;
  Params params_;
  std::map<int64_t, SensedState> states_;  // by key frame
  std::map<int64_t, DoneAction> actions_;  // by index
  std::deque<DoneAction> waiting_;         // for the state at their key frame
  std::deque<DoneAction> deferred_;        // for a state that can be decided
  std::optional<double> last_decided_;     // expected actions after an action
  std::optional<PlanOfState> told_;
};

}  // namespace cell::planner
