#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "services/planner/arms.h"
#include "services/planner/attempts.h"
#include "services/planner/execution.h"
#include "services/planner/plan_search.h"

namespace cell::planner {

/// Does a task with the arms (section VIII-A): the first action of the plan is
/// requested, its end awaited, the state sensed afresh, the plan renewed.
/// Nothing is remembered of the world, so that a person may do any step
/// meanwhile, and a new life of the planner goes on from what it senses once
/// all arms are idle. An arm whose skill a stop or its own death has cut short
/// is first asked to go free of what it is at: until then what is sensed may
/// be under strain. An action that fails again and again without a change of
/// the state is left for another one, or the person is asked. Done is done:
/// what a person takes apart afterwards stays so until there is another goal.
class Executor {
 public:
  struct Params {
    PlanSearch::Params search{Agent::kRobot, {}, 100'000};
    /// [us] after the end of a skill until relations and poses show it.
    int64_t settle_us = 500'000;
    int64_t deadline_us = 1'000'000;    ///< for a skill to begin
    int64_t sense_period_us = 200'000;  ///< until the estimator is asked again
    int64_t watch_period_us = 1'000'000;  ///< the same while stuck
    int64_t patience_us = 5'000'000;      ///< with what cannot be decided
    /// An idle arm that was asked so long ago has lost the request.
    int64_t lost_us = 500'000;
    int max_attempts = 3;  ///< of an action in one state
    bool parallel = true;  ///< pass a part on while another is inserted
    /// Steps that are left to a person, who is asked for them.
    std::set<GroundAction> help_steps = {};
  };

  /// `domain` must outlive this object.
  Executor(const Domain& domain, Goal goal, const Params& params,
           int64_t since_utime);

  void Take(const SensedState& sensed);
  void Take(const ArmStatus& report) { arms_.Take(report); }
  /// Of a request that is not ours: nothing happens.
  void Take(const ArmOutcome& result);
  /// What somebody has moved while we were stuck may now go better.
  void Take(const DoneAction& action);
  /// Whether the cell's mode lets arms begin something.
  void Permit(bool may_act) { may_act_ = may_act; }
  /// From the end of what runs on.
  void Pursue(Goal goal);

  /// Once after all inputs of a moment.
  Orders Decide(Instant now);

 private:
  struct Running {
    int64_t id = 0;
    int64_t asked_utime = 0;  // or when the arm last said that it does it
    ArmOrder::Kind kind = ArmOrder::Kind::kInsert;
    std::optional<GroundAction> action;  // nothing: clearing up
    std::optional<int> part;
    State before;
  };
  struct Asked {
    State state;              // that the question was about
    State latest;             // another one ...
    int64_t since_utime = 0;  // ... that has stayed since then
  };
  enum class Stage { kWorking, kClearingUp, kDone };

  void OnFreed(int arm, bool has_succeeded);
  bool AreFree(Instant now, Orders& orders);
  void Work(Instant now, Orders& orders);
  void FindLostRequests();
  void End(int arm, int64_t utime, bool counts, const std::string& reason);
  bool IsReady(Instant now);
  void Sense(Instant now, int64_t period_us, Orders& orders);
  const Plan& FindPlan(const State& state);
  void Act(const Plan& plan, const State& state, Instant now, Orders& orders);
  void PassOn(const State& state, Instant now, Orders& orders);
  bool IsFree(int arm) const;
  bool IsForPerson(const GroundAction& action) const;
  bool MayRunBeside(const GroundAction& action, const State& state) const;
  void Request(const GroundAction& action, const State& state, Instant now,
               Orders& orders);
  /// `running` needs no more than its action and the state before.
  void Start(ArmOrder request, Running running, Instant now, Orders& orders);
  void WaitOrAsk(const Plan& plan, const State& state, Instant now,
                 Orders& orders);
  void AskPerson(Execution question, const State& state, Instant now,
                 Orders& orders);
  bool IsPersonAtIt(const State& state, Instant now);
  void ClearUp(Instant now, Orders& orders);
  void Tell(Execution execution, Orders& orders);
  std::string WhatRuns() const;

  const Domain& domain_;
  Goal goal_;
  Params params_;
  Arms arms_;
  Attempts attempts_;
  std::optional<PlanSearch> search_;  // for the goal without what is blocked
  std::optional<State> planned_for_;
  Plan plan_;                            // of it
  std::optional<std::string> question_;  // if it is none
  Stage stage_ = Stage::kWorking;
  std::map<int, Running> running_;  // by arm
  /// Arms that were cut short, and how often they have tried in vain to go
  /// free.
  std::map<int, int> to_free_;
  std::optional<SensedState> sensed_;
  bool may_act_ = false;
  bool has_acted_ = false;                  // at the last moment it might
  bool is_ready_ = false;                   // all arms were idle once
  int64_t since_utime_;                     // reports must be at least as young
  int64_t fresh_utime_;                     // a state must be at least as young
  std::optional<int64_t> asked_utime_;      // when sensing was asked for
  std::optional<int64_t> undecided_utime_;  // since when
  std::optional<int64_t> stuck_utime_;      // since when
  std::optional<Asked> asked_for_;          // until a person has acted
  std::map<int, int> num_clearings_;        // failed, by arm
  std::set<int> home_;
  std::string left_over_;  // what clearing up could not do
  int num_requests_ = 0;   // of this moment
  std::optional<Execution> told_;
  std::optional<Monitor::PlanOfState> told_plan_;
};

}  // namespace cell::planner
