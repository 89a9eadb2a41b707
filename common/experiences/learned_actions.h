#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/experiences/rule_lessons.h"
#include "common/experiences/task_experience.h"
#include "common/relational/domain.h"
#include "common/result/result.h"

namespace cell {

/// The actions with the rules that experiences teach (section V-C, see
/// RuleLessons), for a cell that learns while it runs: they rely on nothing
/// that was never shown otherwise, and each says from how many experiences it
/// was learned. Other actions keep what they have. Experiences of actions that
/// are not there, or that do not take such objects, wait until they are.
class LearnedActions {
 public:
  LearnedActions(std::span<const Action> actions, std::span<const Goal> goals,
                 std::shared_ptr<const Vocabulary> vocabulary);

  /// Replaces the actions. What was learned stays if those known before keep
  /// their places and arguments.
  void SetActions(std::span<const Action> actions);
  /// False, and nothing happens, if the id is known.
  bool Add(int64_t id, const TaskExperience& experience);
  /// False if the id is not known.
  bool Remove(int64_t id);

  const std::map<int64_t, TaskExperience>& experiences() const {
    return experiences_;
  }

  /// Learns again what has changed since the last call. Refused: a rule that
  /// the domain has no words for.
  Result<std::vector<Action>> Learn();

 private:
  struct Count {
    std::vector<NdrRule> rules;  // as learned
    std::vector<int> numbers;    // of experiences that each of them covers
  };

  std::optional<GroundAction> ActionOf(const TaskExperience& experience) const;
  void Teach(int64_t id, const TaskExperience& experience);
  void CountExperiences(std::vector<Action>* actions);

  std::shared_ptr<const Vocabulary> vocabulary_;
  std::vector<int> goal_predicates_;
  std::shared_ptr<const RuleWorld> world_;
  RuleLessons lessons_;
  std::map<int64_t, TaskExperience> experiences_;
  std::map<int, Count> counts_;  // by action, if its experiences are the same
};

}  // namespace cell
