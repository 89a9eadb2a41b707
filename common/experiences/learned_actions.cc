#include "common/experiences/learned_actions.h"

#include <algorithm>
#include <optional>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_lessons.h"
#include "common/experiences/rule_world.h"
#include "common/relational/ground_action.h"
#include "common/rules/simulation.h"

namespace cell {
namespace {

/// The experience's action among the actions; nullopt unless it takes these
/// objects.
std::optional<GroundAction> ActionOf(const TaskExperience& experience,
                                     std::span<const Action> actions,
                                     const Vocabulary& vocabulary) {
  const auto place = FindAction(actions, experience.action);
  if (!place) return std::nullopt;
  const auto& arguments = actions[static_cast<size_t>(*place)].arguments;
  if (arguments.size() != experience.objects.size()) return std::nullopt;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (!vocabulary.IsOf(experience.objects[i], arguments[i].type)) {
      return std::nullopt;
    }
  }
  return GroundAction{*place, experience.objects};
}

/// Sets how many experiences each rule of learned actions covers.
void CountExperiences(std::span<const TaskExperience> experiences,
                      const Vocabulary& vocabulary,
                      std::vector<Action>* actions) {
  for (const TaskExperience& experience : experiences) {
    const auto ground = ActionOf(experience, *actions, vocabulary);
    if (!ground) continue;
    Action& action = (*actions)[static_cast<size_t>(ground->action)];
    const State before = experience.before.UnknownAsFalse();
    for (const ApplicableRule& applicable :
         ApplicableRules(action, ground->arguments, before, vocabulary,
                         action.agents.front())) {
      ++action.rules[static_cast<size_t>(applicable.rule)].num_experiences;
    }
  }
}

}  // namespace

Result<std::vector<Action>> LearnActions(
    std::span<const TaskExperience> experiences,
    std::span<const Action> actions, std::span<const Goal> goals,
    const std::shared_ptr<const Vocabulary>& vocabulary) {
  const RuleWorld world(vocabulary, actions);
  std::vector<rules::Experience> known;
  std::vector<TaskExperience> of_known;
  for (const TaskExperience& experience : experiences) {
    const auto ground = ActionOf(experience, actions, *vocabulary);
    if (!ground) continue;
    of_known.push_back(experience);
    known.push_back(
        world.ToExperience(experience.before, *ground, experience.after));
  }
  if (known.empty()) return std::vector(actions.begin(), actions.end());
  auto learned = WithLearnedRules(
      LearnRules(known, GoalPredicates(goals), world, 1), world);
  if (!learned) return learned;
  std::vector<Action> result = *std::move(learned);
  CountExperiences(of_known, *vocabulary, &result);
  return result;
}

}  // namespace cell
