#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/experiences/specialization.h"
#include "common/relational/domain.h"
#include "common/rules/experience.h"
#include "common/rules/rule.h"

namespace cell {

/// The predicates that the goals name, ascending.
std::vector<int> GoalPredicates(std::span<const Goal> goals);

/// Learns the rules of a task's actions from experiences (section V-C):
/// rules::Learner, by OwnChanges(), then Specialization, and
/// AddEffectsOnOthers(). An action that was never experienced is learned from
/// the reversed experiences of the one that it undoes. The probabilities are
/// those after one more experience of each rule that is noise (rule of
/// succession): no rule is sure.
/// Of an action with many experiences, one or two make no rule.
///
/// Experiences may come and go. Learn() learns those actions again whose
/// experiences have changed, and of others what the states seen with them
/// change; the rules are those that learning all of them again would give.
class RuleLessons {
 public:
  /// @param goal_predicates  of the vocabulary: the landmarks of Specialization
  /// @param num_for_others   of Specialization; 1: what was never shown
  /// otherwise is not relied on
  RuleLessons(std::shared_ptr<const RuleWorld> world,
              std::span<const int> goal_predicates,
              int num_for_others = kManySuccesses);

  /// An action is learned from its experiences in the order of their ids.
  /// @throws std::invalid_argument for an id that is there already
  void Add(int64_t id, const rules::Experience& experience);
  /// Nothing happens if there is none.
  void Remove(int64_t id);
  /// Another world with the same predicates and objects, and with more actions.
  /// @throws std::invalid_argument if a symbol is not where it was
  void SetWorld(std::shared_ptr<const RuleWorld> world);

  /// By action, in the order of the symbols; the rules that cover most first.
  rules::NdrRules Learn();

 private:
  /// What is known of one action.
  struct Lesson {
    std::map<int64_t, rules::Experience> done;
    bool is_open = false;              // has to be learned again
    std::optional<SeenAtoms> seen;     // in what it was learned from
    std::vector<rules::Rule> learned;  // by rules::Learner
    std::vector<rules::Rule> specialized;
    std::vector<rules::Rule> rules;  // with effects on others
  };
  using Experiences = std::vector<rules::Experience>;

  const rules::World& world() const { return *world_->world(); }
  Specialization::Params ParamsOf(std::span<const int> goal_predicates,
                                  int num_for_others) const;
  /// The symbol of the action that it undoes.
  std::optional<int> UndoneBy(int action) const;
  Experiences ExperiencesOf(int action) const;
  void FindBindings(const rules::WorldState& state);
  Experiences OwnOf(const Experiences& experiences) const;
  void Open(int action);
  void LearnAlone(int action, Lesson* lesson) const;
  void Finish(int action, const SeenAtoms& seen, Lesson* lesson) const;

  std::shared_ptr<const RuleWorld> world_;
  std::vector<int> goal_predicates_;
  int num_for_others_;
  Specialization specialization_;
  std::map<int, Lesson> lessons_;  // by action
  // All objects that the types of each action allow.
  std::map<int, std::vector<std::vector<int>>> bindings_;
  std::map<int64_t, int> action_of_id_;  // of each experience
  std::optional<SeenAtoms> seen_;        // in all of them, when last learned
};

/// What all experiences teach, in their order.
rules::NdrRules LearnRules(std::span<const rules::Experience> experiences,
                           std::span<const int> goal_predicates,
                           const RuleWorld& world,
                           int num_for_others = kManySuccesses);

}  // namespace cell
