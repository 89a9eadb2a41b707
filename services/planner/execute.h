#pragma once

#include <memory>

#include "services/planner/decision_state.h"
#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Does a task with the arms (section VIII-A): the first action of the plan is
/// requested, its end awaited, the state sensed again, the plan renewed. It
/// keeps no memory of the world, so that a person may do any step meanwhile,
/// and a restarted planner goes on from what it senses once all arms are idle.
/// If an action has failed too often, another one is tried, or the person is
/// asked. Its states: execution/execution_state.h.
class Execute final : public DecisionState {
 public:
  Execute(std::shared_ptr<const RuleSet> rules, const Goal& goal,
          SolverMaker make_solver, const ExecutionParams& params, bool may_act,
          Instant now);

  Decisions OnSensed(const SensedState& sensed) override;
  /// Actions with parts that a person moved during a question may now succeed.
  Decisions OnAction(const DoneAction& action) override;
  void OnArmState(const ArmState& report) override;
  void OnSkillResult(const SkillResult& result) override;
  void SetPermission(bool may_act, Instant now) override;
  Decisions SetRules(std::shared_ptr<const RuleSet> rules) override;
  void SetExperiences(
      std::shared_ptr<const std::vector<TaskExperience>> experiences) override;
  void SetSecModels(std::shared_ptr<const SecModels> models) override {
    context_.params.sec_models = std::move(models);
  }
  void Confirm(const std::string& action) override;
  bool HasGoal() const override { return true; }
  /// From the end of what runs on.
  Decisions SetGoal(const Goal& goal) override;
  Decisions Decide(Instant now) override;
  std::optional<DecisionBasis> Basis() const override;

  const ExecutionState& state() const { return *state_; }

 private:
  void OnSkillEnd(const EndedSkill& ended);
  void BeginTrial(const EndedSkill& ended);
  void EndTrials(Decisions& out);

  ExecutionContext context_;
  std::unique_ptr<ExecutionState> state_;
};

}  // namespace cell::planner
