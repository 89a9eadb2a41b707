#pragma once

#include <span>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/relational/domain.h"
#include "common/rules/experience.h"
#include "common/rules/rule.h"

namespace cell {

/// The experience with the changes of its action's own objects only; all other
/// changes are undone.
rules::Experience OwnChanges(const rules::Experience& experience,
                             const RuleWorld& world);

/// The experience of an action of which another one is known that reverses it:
/// what was after that one is before this one.
rules::Experience Reversed(const rules::Experience& experience, int action);

/// Makes the rule as special as the experiences that it covers and in which it
/// changed something: adds the literals that held before each of them, and that
/// do not hold always. A few experiences make a rule that is safe, and each
/// further one can only make it more general. So that no accident of how the
/// other parts lie becomes a condition, literals that name no argument of the
/// action are added to rules with many successes only, and those that name no
/// object at all (only `_`) are of `landmarks` only.
/// @param rule  covers at least one of them
/// @param experiences  all that there are, of any action
/// @param landmarks  symbols
void Specialize(std::span<const rules::Experience> experiences,
                std::span<const int> landmarks, const rules::World& world,
                rules::Rule* rule);

/// The predicates that the goals name, ascending.
std::vector<int> GoalPredicates(std::span<const Goal> goals);

/// Learns the rules of a task's actions from experiences (section V-C):
/// rules::Learner, by OwnChanges(), then Specialize(), and
/// AddEffectsOnOthers(). An action that was never experienced is learned from
/// the reversed experiences of the one that it undoes. The probabilities are
/// those after one more experience of each rule that is noise (rule of
/// succession): no rule is sure.
/// @param goal_predicates  of the vocabulary: the landmarks of Specialize()
rules::NdrRules LearnRules(std::span<const rules::Experience> experiences,
                           std::span<const int> goal_predicates,
                           const RuleWorld& world);

}  // namespace cell
