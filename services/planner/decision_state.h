#pragma once

#include <memory>
#include <optional>

#include "services/planner/arm_states.h"
#include "services/planner/decision_basis.h"
#include "services/planner/decisions.h"
#include "services/planner/observations.h"
#include "services/planner/solver.h"
#include "services/planner/stand_in_offer.h"

namespace cell::planner {

/// What the decision maker does at a time: nothing, watch a person, execute a
/// task with the arms. Inputs that a state has no use for are passed over.
class DecisionState {
 public:
  DecisionState() = default;
  DecisionState(const DecisionState&) = delete;
  DecisionState& operator=(const DecisionState&) = delete;
  virtual ~DecisionState() = default;

  virtual Decisions OnSensed(const SensedState&) { return {}; }
  virtual Decisions OnAction(const DoneAction&) { return {}; }
  virtual void OnArmState(const ArmState&) {}
  virtual void OnSkillResult(const SkillResult&) {}
  /// Whether the cell's mode lets arms begin something.
  virtual void SetPermission(bool /*may_act*/, Instant) {}
  /// Replaces the rule set and plans again at once.
  virtual Decisions SetRules(std::shared_ptr<const RuleSet>) { return {}; }
  /// What the rules were learned from, if the cell learns.
  virtual void SetExperiences(
      std::shared_ptr<const std::vector<TaskExperience>>) {}

  /// How actions show, by which parts are known that can stand in for others.
  virtual void SetSecModels(std::shared_ptr<const SecModels>) {}

  /// An operator lets arms do a learned action for the first time.
  virtual void Confirm(const std::string& /*action*/) {}

  /// True if an episode with a replaceable goal runs.
  virtual bool HasGoal() const { return false; }
  virtual Decisions SetGoal(const Goal&) { return {}; }

  /// What is decided by at present; nullopt if nothing was planned.
  virtual std::optional<DecisionBasis> Basis() const { return std::nullopt; }

  /// Once a tick, after all inputs.
  virtual Decisions Decide(Instant) { return {}; }
  /// Once a second, for what is not urgent.
  virtual Decisions Review(Instant) { return {}; }

  /// The episode has ended. False: nothing is left to do.
  virtual bool OnEpisodeEnd(Instant) { return false; }
  /// The last decisions of this state before another one takes over.
  virtual Decisions Conclude(Instant) { return {}; }
};

/// No episode, or none that can be decided about.
class Idle final : public DecisionState {};

}  // namespace cell::planner
