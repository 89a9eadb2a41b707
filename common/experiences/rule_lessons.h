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

/// Of those that hold as often as not, none of a hundred literals is likely to
/// hold before each of so many successes by accident.
inline constexpr int kManySuccesses = 12;

/// Makes the rule as special as the experiences that it covers and in which it
/// changed something: adds the literals that held before each of them (one in
/// twenty may have been sensed wrongly), and that do not hold always: of these
/// objects, or, if they are about one object, of any other. A few
/// experiences make a rule that is safe, and each further one can only make it
/// more general. So that no accident of how the other parts lie becomes a
/// condition, literals that name no argument of the action are added to rules
/// with many successes only, and those that name no object at all (only `_`)
/// are of `landmarks` only.
/// @param rule  covers at least one of them
/// @param experiences  all that there are, of any action
/// @param landmarks  symbols
/// @param num_for_others  successes that literals without an argument need
void Specialize(std::span<const rules::Experience> experiences,
                std::span<const int> landmarks, const rules::World& world,
                rules::Rule* rule, int num_for_others = kManySuccesses);

/// The predicates that the goals name, ascending.
std::vector<int> GoalPredicates(std::span<const Goal> goals);

/// Learns the rules of a task's actions from experiences (section V-C):
/// rules::Learner, by OwnChanges(), then Specialize(), and
/// AddEffectsOnOthers(). An action that was never experienced is learned from
/// the reversed experiences of the one that it undoes. The probabilities are
/// those after one more experience of each rule that is noise (rule of
/// succession): no rule is sure.
/// Of an action with many experiences, one or two make no rule.
/// @param goal_predicates  of the vocabulary: the landmarks of Specialize()
/// @param num_for_others   of Specialize(); 1: what was never shown otherwise
/// is not relied on
rules::NdrRules LearnRules(std::span<const rules::Experience> experiences,
                           std::span<const int> goal_predicates,
                           const RuleWorld& world,
                           int num_for_others = kManySuccesses);

}  // namespace cell
