#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "common/relational/request_words.h"
#include "services/planner/decisions.h"
#include "services/planner/observations.h"
#include "services/planner/solver.h"

namespace cell::planner {

/// Watches a person do a task (section VII-C): after each action there must be
/// a way to the goal, and it must not have become longer by the action. Pairs
/// actions with the state at their key frame, whichever comes first.
class Monitor {
 public:
  struct Params {
    /// An action that lengthens the plan by more than this number of expected
    /// actions is a deviation; the least true one is 1.
    double min_detour = 0.5;
    /// States and actions that are remembered: of the latest key frames. An
    /// action that lasts longer is compared with the oldest one.
    int max_remembered = 1024;
    RequestWords requests = {};  ///< how the person is asked
  };

  /// `solver` is of these rules.
  Monitor(std::shared_ptr<const RuleSet> rules, std::unique_ptr<Solver> solver,
          const Params& params);

  /// A plan is reported for the first state, after an action, and when it
  /// changes; at most one alert for an action, ever.
  Decisions Update(const SensedState& sensed);
  Decisions Update(const DoneAction& action);
  /// Goes on by other rules: plans for the latest state, and compares no plan
  /// with one by the rules before.
  Decisions SetRules(std::shared_ptr<const RuleSet> rules,
                     std::unique_ptr<Solver> solver);

  /// Nullptr before the first one.
  const SensedState* latest() const {
    return states_.empty() ? nullptr : &states_.rbegin()->second;
  }
  /// The plan of the latest state.
  const std::optional<PlanOfState>& reported() const { return reported_; }

 private:
  /// Judges the action by the state after it. While that is undecided the
  /// action waits for one that is not.
  std::optional<Alert> Judge(const DoneAction& action,
                             const SensedState& after);
  std::string HelpFrom(const Plan& no_plan) const;
  Judgement WithStates(const DoneAction& action, const State& after);
  /// The state had the action not been made.
  std::optional<State> StateWithout(const DoneAction& action,
                                    const State& after) const;
  std::vector<Alert> JudgeDeferred(const SensedState& after);
  void Forget();
  Decisions Report(std::vector<Alert> alerts, bool has_acted);

  std::shared_ptr<const RuleSet> rules_;
  std::unique_ptr<Solver> solver_;
  Params params_;
  std::map<int64_t, SensedState> states_;  // by key frame
  std::map<int64_t, DoneAction> actions_;  // by index
  std::deque<DoneAction> waiting_;         // for the state at their key frame
  std::deque<DoneAction> deferred_;        // for a state that can be decided
  std::optional<double> last_decided_;     // expected actions after an action
  std::optional<PlanOfState> reported_;
};

}  // namespace cell::planner
