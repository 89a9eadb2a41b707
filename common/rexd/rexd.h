#pragma once

#include <optional>
#include <set>

#include "common/planning/planner.h"
#include "common/rexd/agent_rates.h"
#include "common/rexd/dangerous_acts.h"
#include "common/rexd/guidance.h"
#include "common/rexd/rule_model.h"
#include "common/rules/learning/learner.h"
#include "common/rules/simulation.h"

namespace cell::rexd {

/// What to do next (section VI-B).
struct Decision {
  enum class Kind { kExplore, kExploit, kAsk };
  Kind kind = Kind::kAsk;
  rules::GroundAct act;  ///< unless kAsk
  Guidance guidance;     ///< for the teacher, if kAsk
};

/// REX-D (Martinez et al., AIJ 2017; the paper's Fig. 16): in a state that is
/// not known, the action that was tried least; in a known state, the first
/// action of a plan; if there is none, what else can be done towards the goal,
/// then one demonstration. Begins without any action: a demonstration adds its
/// own.
class RexD {
 public:
  struct Params {
    rules::LearnerOptions learner;
    /// Experiences of the rule that covers it, from which on an action is
    /// known.
    int known_count = 2;
    /// Whether actions are explored of which the rules expect no change.
    bool explores_no_ops = true;
    /// Asks when an action that should have changed something has failed so
    /// often in a row that this was less likely.
    double least_failure_probability = 0.02;
    /// A demonstration that changed nothing is of use all the same, or the
    /// teacher would not have shown it: it is repeated so often at most.
    int max_repetitions = 6;
    /// Whether subgoals are reached before a demonstration is asked for.
    bool uses_subgoals = true;
    /// Rules with another precondition that are tried in a state before a
    /// demonstration is asked for.
    int max_alternatives = 1;
    /// Of the planner; a plan that takes more is none.
    int64_t max_expansions = 3000;
    uint64_t seed = 1;
  };

  /// @param task  must outlive this
  RexD(const RexdTask& task, const Params& params);

  /// Goes on in another task of the same world with all that was learned; only
  /// dead ends, which are those of a goal, are forgotten.
  /// @param task  must outlive this
  /// @throws std::invalid_argument if its world is another one
  void SetTask(const RexdTask& task);

  Decision Decide(const rules::WorldState& state);
  /// @param is_demonstrated  whether the teacher did it
  void Observe(const rules::Experience& experience,
               bool is_demonstrated = false);
  /// The goal cannot be reached from the state of the last experience. From now
  /// on, no action is done by itself that may lead to what looks like it.
  void RememberDeadEnd();

  const rules::NdrRules& rules() const { return rules_; }
  const std::vector<int>& rule_counts() const { return counts_; }
  const rules::Learner& learner() const { return learner_; }
  /// The rules with the success rates of the robot alone, which may fail more
  /// often than the teacher.
  AgentRules RobotRules() const;
  const DeadEndMemory& dead_ends() const { return dangers_.dead_ends(); }
  /// The rules as they are, with all actions that were seen.
  std::shared_ptr<RuleModel> Model() const;
  /// The first action of the best plan by the rules as they are; nullopt if
  /// there is none.
  std::optional<rules::GroundAct> Plan(const rules::WorldState& state);

 private:
  /// Of the last action, in a row.
  struct FailureStreak {
    int number = 0;
    double p_at_first = 0;  ///< that it would change anything, at the first
  };

  planning::Planner::Params PlannerParams() const;
  std::optional<rules::GroundAct> PlanBy(const rules::NdrRules& rules,
                                         const RexdTask& task,
                                         const rules::WorldState& state) const;
  /// The first action of a plan by a rule alternative, or for the subgoals.
  std::optional<rules::GroundAct> DoWithoutPlan(const rules::WorldState& state,
                                                const Guidance& guidance);
  std::optional<rules::GroundAct> LeastTried(const rules::WorldState& state);
  bool HasFailedTooOften(const rules::GroundAct& act,
                         const rules::WorldState& state) const;
  std::vector<rules::GroundAct> KnownActs() const;
  /// Probability that the rules give to any change, as if there were two more
  /// experiences, one with a change (rule of succession).
  double ChangeProbability(const rules::GroundAct& act,
                           const rules::WorldState& state) const;
  /// True if the rules are sure that nothing changes.
  bool IsNoOp(const rules::GroundAct& act,
              const rules::WorldState& state) const;

  const RexdTask* task_;
  Params params_;
  rules::Learner learner_;
  rules::NdrRules rules_;
  std::vector<int> counts_;  // of each rule
  std::vector<rules::Experience> experiences_;
  std::vector<rules::Experience> robot_experiences_;  // not demonstrated
  std::set<int> actions_;                             // that were seen
  rules::RandomNumbers random_;
  std::optional<rules::Experience> last_;
  FailureStreak failures_;
  std::optional<rules::GroundAct> shown_in_vain_;
  int num_repetitions_ = 0;
  DangerousActs dangers_;
  int num_alternatives_ = 0;  // tried in this state since one was shown
};

}  // namespace cell::rexd
