#include "common/relational/robot_addition.h"

#include <algorithm>

namespace cell {
namespace {

/// The effect of the outcome that has no condition.
Effect& PlainEffectOf(Outcome& outcome) {
  const auto plain =
      std::ranges::find_if(outcome.effects, [](const Effect& effect) {
        return effect.each.empty() && effect.where.empty();
      });
  if (plain != outcome.effects.end()) return *plain;
  return outcome.effects.emplace_back();
}

NdrRule With(NdrRule rule, const RobotAddition& addition) {
  rule.agents = {Agent::kRobot};
  rule.context.insert(rule.context.end(), addition.context.begin(),
                      addition.context.end());
  for (Outcome& outcome : rule.outcomes) {
    std::vector<Literal>& then = PlainEffectOf(outcome).then;
    then.insert(then.end(), addition.effects.begin(), addition.effects.end());
  }
  return rule;
}

}  // namespace

bool Contradicts(const NdrRule& rule, const RobotAddition& addition) {
  const auto contradicts = [&](const Literal& effect) {
    return std::ranges::any_of(addition.effects, [&](const Literal& added) {
      return Contradict(effect, added);
    });
  };
  return std::ranges::any_of(rule.outcomes, [&](const Outcome& outcome) {
    return std::ranges::any_of(outcome.effects, [&](const Effect& effect) {
      return effect.each.empty() &&
             std::ranges::any_of(effect.then, contradicts);
    });
  });
}

void AddForRobot(std::span<const RobotAddition> additions,
                 const std::function<bool(const NdrRule&)>& is_meant,
                 Action* action) {
  std::vector<NdrRule> of_robot;
  for (NdrRule& rule : action->rules) {
    if (!rule.IsFor(Agent::kRobot) || !is_meant(rule)) continue;
    for (const RobotAddition& addition : additions) {
      of_robot.push_back(With(rule, addition));
    }
    std::erase(rule.agents, Agent::kRobot);
  }
  std::erase_if(action->rules,
                [](const NdrRule& rule) { return rule.agents.empty(); });
  action->rules.insert(action->rules.end(), of_robot.begin(), of_robot.end());
}

}  // namespace cell
