#pragma once

#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "common/planning/model.h"
#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// Rules as a Markov decision process for the planner. Actions that no rule, or
/// several rules, cover change nothing; nor does noise.
class RuleModel final : public planning::Model {
 public:
  using IsForbidden =
      std::function<bool(const rules::GroundAct&, const rules::WorldState&)>;

  /// @param acts  the actions that may be used
  /// @param is_forbidden  in which states they may not; empty: in none
  RuleModel(rules::NdrRules rules, const RexdTask& task,
            std::vector<rules::GroundAct> acts, IsForbidden is_forbidden = {});

  const std::vector<rules::GroundAct>& acts() const { return acts_; }
  std::vector<uint64_t> Pack(const rules::WorldState& state) const;

  int num_words() const override;
  bool IsGoal(planning::Bits state) const override;
  void Expand(planning::Bits state,
              planning::Expansion* expansion) const override;
  std::string ActionName(int action) const override;
  /// Clears atoms that neither the goal nor any condition asks for, unless
  /// actions may be forbidden because of them. A state
  /// is a dead end if no rule brings about something that the goal lacks.
  planning::Estimate Assess(std::span<uint64_t> state) const override;

 private:
  rules::WorldState Unpack(planning::Bits bits) const;
  void FindRelevant();
  void FindAchievable();
  void AddAchievable(const rules::Rule& rule, const rules::GroundAct& act);
  /// What a term of the rule may stand for: a reference, any object.
  std::vector<int> ObjectsOf(const rules::Term& term,
                             const rules::GroundAct& act) const;
  bool MayEverHold(const rules::Literal& literal,
                   const rules::GroundAct& act) const;
  bool IsMissing(const rules::Literal& goal, planning::Bits state) const;

  rules::NdrRules rules_;
  const RexdTask& task_;
  std::vector<rules::GroundAct> acts_;
  IsForbidden is_forbidden_;
  std::vector<uint64_t> relevant_;  // bits of a state
  /// Ground atoms that a rule makes true, or false: 2 * place + truth.
  std::set<int> achievable_;
  std::set<int> changing_;         // symbols that a rule changes
  std::vector<size_t> coverable_;  // acts that a rule may ever cover
  int most_changes_ = 1;           // of the goal's symbols, by one action
};

}  // namespace cell::rexd
