#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "services/planner/decision_state.h"
#include "services/planner/monitor.h"
#include "services/planner/unexplained_changes.h"

namespace cell::planner {

/// Watches a person do a task: reports plans, deviations (Monitor) and changes
/// that no recognised action explains (UnexplainedChanges).
class Watch final : public DecisionState {
 public:
  struct Params {
    Monitor::Params monitor = {};
    UnexplainedChanges::Params unexplained = {};
  };

  /// @param goals  of the task; `goal` is the one to be reached
  Watch(std::shared_ptr<const RuleSet> rules, std::span<const Goal> goals,
        const Goal& goal, SolverMaker make_solver, const Params& params,
        bool has_joined_late);

  Decisions OnSensed(const SensedState& sensed) override;
  Decisions OnAction(const DoneAction& action) override;
  Decisions SetRules(std::shared_ptr<const RuleSet> rules) override;
  bool HasGoal() const override { return !is_over_; }
  Decisions SetGoal(const Goal& goal) override;
  Decisions Decide(Instant now) override;
  Decisions Review(Instant now) override;
  bool OnEpisodeEnd(Instant now) override;
  Decisions Conclude(Instant now) override;
  std::optional<DecisionBasis> Basis() const override;

 private:
  std::unique_ptr<Solver> MakeSolver() const;

  std::shared_ptr<const RuleSet> rules_;
  Goal goal_;
  SolverMaker make_solver_;
  Params params_;
  Monitor monitor_;
  UnexplainedChanges unexplained_;
  bool is_over_ = false;                   // the episode
  std::optional<int64_t> conclude_utime_;  // when all of it is recognised
};

}  // namespace cell::planner
