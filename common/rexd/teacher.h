#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "common/planning/planner.h"
#include "common/rexd/guidance.h"
#include "common/rexd/rule_model.h"
#include "common/rules/simulation.h"

namespace cell::rexd {

/// What the learner says when it asks (section VI-B1): the rules that it has,
/// and why they do not do.
struct Question {
  const rules::NdrRules* known = nullptr;
  const Guidance* guidance = nullptr;
};

/// Shows one action at a time.
class Teacher {
 public:
  Teacher() = default;
  Teacher(const Teacher&) = delete;
  Teacher& operator=(const Teacher&) = delete;
  virtual ~Teacher() = default;

  /// An action that leads towards the goal; nullopt if there is none: a dead
  /// end.
  virtual std::optional<rules::GroundAct> Choose(const rules::WorldState& state,
                                                 const Question& question) = 0;
  /// What happens when the teacher does it.
  virtual rules::WorldState Act(const rules::GroundAct& act,
                                const rules::WorldState& state) = 0;
};

/// Plans with the true rules.
class PlanningTeacher final : public Teacher {
 public:
  struct Params {
    /// Shows what the learner cannot predict, and of that what it asks for: an
    /// effect that it misses, or an action that it believes to be blocked.
    bool heeds_guidance = true;
    /// Never fails; otherwise as often as the robot.
    bool is_sure = true;
  };

  /// @param success  of the robot's actions, see WithSuccess()
  PlanningTeacher(const RexdTask& task, double success, const Params& params,
                  uint64_t seed);

  std::optional<rules::GroundAct> Choose(const rules::WorldState& state,
                                         const Question& question) override;
  rules::WorldState Act(const rules::GroundAct& act,
                        const rules::WorldState& state) override;
  /// Actions to the goal if all succeed; nullopt if it cannot be reached.
  std::optional<double> DistanceFrom(const rules::WorldState& state);
  /// Actions that bring the goal nearer if they succeed.
  std::vector<rules::GroundAct> UsefulActs(const rules::WorldState& state);

  /// The state after the action if it succeeds.
  rules::WorldState Intended(const rules::GroundAct& act,
                             const rules::WorldState& state) const;

 private:
  bool IsAskedFor(const rules::GroundAct& act, const rules::WorldState& state,
                  const Guidance& guidance) const;

  const RexdTask& task_;
  Params params_;
  rules::NdrRules robot_;
  std::shared_ptr<RuleModel> model_;
  planning::Planner planner_;
  rules::RandomNumbers random_;
  std::map<std::vector<uint64_t>, std::optional<double>> distances_;
};

}  // namespace cell::rexd
