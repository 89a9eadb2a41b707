#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/rexd/rexd_task.h"
#include "common/rules/learning/learner.h"
#include "common/rules/simulation.h"

namespace cell::rexd {

/// Learns what actions do by itself, without a teacher and without a goal.
///
/// The situation of an action is what holds of its arguments. Each situation is
/// tried; first those that differ least from one in which the action did
/// something, since these tell which literals it needs. If the best of them is
/// not at hand, the rules learned so far lead there.
class Explorer {
 public:
  struct Params {
    rules::LearnerOptions learner;
    /// Experiences of a situation from which on it is known: one is enough
    /// where actions do not fail by chance.
    int known_count = 1;
    /// Actions to a better situation that are thought through at most.
    int max_depth = 4;
    /// States that are looked at for one decision.
    int max_states = 300;
    /// Literals of difference that one action more is worth.
    double action_cost = 1;
    uint64_t seed = 1;
  };

  /// @param task  its actions may all be tried; must outlive this
  Explorer(const RexdTask& task, const Params& params);

  /// @throws std::invalid_argument if no action is possible with any objects
  rules::GroundAct Choose(const rules::WorldState& state);
  void Observe(const rules::Experience& experience);
  const rules::NdrRules& rules() const { return rules_; }

 private:
  /// Truth of all literals over the arguments of an action, `_` included.
  using Situation = std::vector<bool>;
  struct Trials {
    int num_trials = 0;
    std::map<Situation, int> counts;
    std::set<Situation> positives;  ///< in which something changed
  };
  std::vector<rules::Literal> LiteralsOf(int action) const;
  Situation SituationOf(const rules::GroundAct& act,
                        const rules::WorldState& state) const;
  /// How little is to be expected of trying it; nullopt if it is known.
  std::optional<double> CostOf(const rules::GroundAct& act,
                               const rules::WorldState& state) const;
  /// The acts of least cost in a state, with that cost.
  std::pair<double, std::vector<rules::GroundAct>> BestActs(
      const rules::WorldState& state) const;
  /// The likeliest state after the act by the rules; nullopt if unchanged, or
  /// if its situation is known to change nothing.
  std::optional<rules::WorldState> Expected(
      const rules::GroundAct& act, const rules::WorldState& state) const;
  const rules::GroundAct& AnyOf(const std::vector<rules::GroundAct>& acts);

  const RexdTask& task_;
  Params params_;
  rules::Learner learner_;
  rules::NdrRules rules_;
  rules::RandomNumbers random_;
  std::vector<rules::GroundAct> acts_;
  std::map<int, std::vector<rules::Literal>> literals_;  // by action
  std::map<int, Trials> trials_;                         // by action
};

}  // namespace cell::rexd
