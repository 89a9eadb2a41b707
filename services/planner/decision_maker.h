#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/result/result.h"
#include "services/planner/decision_state.h"
#include "services/planner/execution/execution_context.h"
#include "services/planner/watch.h"

namespace cell::planner {

/// An episode that begins, or that runs when the planner starts.
struct Episode {
  bool has_joined_late = false;
  std::string agent;  ///< pursues the goal: person or robot
  std::string goal;   ///< name
};

/// The decision maker (sections VII-B, VIII-A): one state at a time.
///
///     any --episode of a person--> Watch
///     any --episode of the robot--> Execute --its end--> Idle
///     any --episode without known agent and goal--> Idle
///
/// Watch outlasts the end of its episode, since the last actions are recognised
/// later. Asking to be shown what nobody has shown yet is a part of Execute.
class DecisionMaker {
 public:
  struct Params {
    std::vector<Goal> goals;  ///< of the task
    SolverMaker make_solver;
    Watch::Params watch = {};
    ExecutionParams execution = {};
  };
  /// The decisions that follow from an input, or why it is refused.
  using Answer = Result<Decisions>;

  DecisionMaker(std::shared_ptr<const RuleSet> rules, Params params);

  const RuleSet& rules() const { return *rules_; }
  bool is_learning() const { return params_.execution.exploration.has_value(); }
  /// Replaces the rule set while a state goes on, and plans again by the new
  /// one. Refused with the reason of RuleSet::WhyNotReplace().
  Answer ReplaceRules(std::shared_ptr<const RuleSet> rules);
  /// What they were learned from, if the cell learns.
  void SetExperiences(
      std::shared_ptr<const std::vector<TaskExperience>> experiences);

  /// How actions show, as far as the cell knows.
  void SetSecModels(std::shared_ptr<const SecModels> models);

  /// An operator lets arms do a learned action for the first time. Refused, in
  /// plain words, for an action that is not known, or if the cell does not
  /// learn.
  Answer Confirm(const std::string& action);

  Decisions OnEpisode(const Episode& episode, Instant now);
  void OnEpisodeEnd(Instant now);
  /// Refused for an unknown name, and if no episode runs.
  Answer SetGoal(const std::string& name);
  void SetPermission(bool may_act, Instant now);

  /// Takes all other inputs.
  DecisionState& state() { return *state_; }

 private:
  const Goal* FindGoal(const std::string& name) const;
  std::string NoGoal(const std::string& name) const;
  Decisions Begin(const Episode& episode, Instant now);

  std::shared_ptr<const RuleSet> rules_;
  Params params_;
  std::unique_ptr<DecisionState> state_;
  bool may_act_ = false;
};

}  // namespace cell::planner
