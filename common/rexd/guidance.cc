#include "common/rexd/guidance.h"

#include <algorithm>

#include "common/planning/excuse.h"
#include "common/rexd/rule_task.h"

namespace cell::rexd {

using namespace rules;
namespace {

Literal LiteralOf(const planning::Literal& literal, const RuleTask& task) {
  Literal ground = task.atoms[static_cast<size_t>(literal.atom)];
  if (!literal.value) ground.comparison = Comparison::kFalse;
  return ground;
}

std::string Show(const Literal& literal, const World& world) {
  std::vector<int> objects;
  for (const Term& term : literal.terms) objects.push_back(term.index);
  return (literal.comparison == Comparison::kFalse ? "not " : "") +
         world.Show(literal.symbol, objects);
}

template <class T, class Equal>
void AddNew(std::vector<T>* list, T element, const Equal& equals) {
  const bool is_there = std::ranges::any_of(
      *list, [&](const T& old) { return equals(old, element); });
  if (!is_there) list->push_back(std::move(element));
}

void AddChange(const planning::RequiredChange& change, const RuleTask& task,
               const std::vector<Literal>& goal, Guidance* guidance) {
  const Literal needed = LiteralOf(change.literal, task);
  const bool is_wished = std::ranges::find(goal, needed) != goal.end();
  if (is_wished || !change.has_producer) {
    AddNew(&guidance->missing_effects, needed, std::equal_to<>());
  }
  for (const std::string& name : change.needed_by) {
    const auto it = std::ranges::find(task.task.actions, name,
                                      &planning::GroundAction::name);
    if (it == task.task.actions.end()) continue;
    const auto i = static_cast<size_t>(it - task.task.actions.begin());
    AddNew(&guidance->blocked_acts,
           Guidance::BlockedAct{task.act_of[i], needed},
           [](const auto& a, const auto& b) {
             return a.act == b.act && a.needs == b.needs;
           });
  }
}

}  // namespace

Guidance FindGuidance(const NdrRules& rules, const RexdTask& task,
                      const WorldState& state,
                      const std::vector<GroundAct>& acts) {
  Guidance guidance;
  const auto ground = GroundRuleTask(rules, task, state, acts);
  if (!ground) return guidance;
  planning::ExcuseOptions options;
  options.max_trials = 2000;
  options.max_expansions = 1000;
  planning::Excuses excuses;
  for (const bool may_wish : {false, true}) {
    options.max_changes = may_wish ? static_cast<int>(task.goal.size()) : 2;
    options.may_change = [&](const planning::Literal& l) {
      const Literal literal = LiteralOf(l, *ground);
      return may_wish ==
             (std::ranges::find(task.goal, literal) != task.goal.end());
    };
    excuses = FindExcuses(ground->task, options);
    if (excuses.is_solvable || !excuses.excuses.empty()) break;
  }
  for (const planning::Excuse& excuse : excuses.excuses) {
    for (const auto& change : excuse.changes) {
      AddChange(change, *ground, task.goal, &guidance);
    }
  }
  if (excuses.excuses.empty()) return guidance;
  for (const planning::Literal& l : excuses.excuses.front().subgoals) {
    guidance.subgoals.push_back(LiteralOf(l, *ground));
  }
  return guidance;
}

std::string ToText(const Guidance& guidance, const World& world) {
  std::string text;
  for (const Literal& effect : guidance.missing_effects) {
    text += "I know no action after which " + Show(effect, world) + ".\n";
  }
  for (const Guidance::BlockedAct& blocked : guidance.blocked_acts) {
    text += "I believe that " +
            world.Show(blocked.act.action, blocked.act.arguments) +
            " would help, but that it needs " + Show(blocked.needs, world) +
            ", which I cannot reach.\n";
  }
  return text;
}

}  // namespace cell::rexd
