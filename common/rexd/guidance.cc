#include "common/rexd/guidance.h"

#include <algorithm>
#include <cstdint>

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

planning::ExcuseOptions SearchLimits() {
  planning::ExcuseOptions options;
  options.max_trials = 2000;
  options.max_expansions = 1000;
  return options;
}

/// Finds the excuses of a state and adds what they say.
class GuidanceFinder {
 public:
  GuidanceFinder(const RuleTask& ground, const std::vector<Literal>& goal)
      : ground_(ground), goal_(goal) {}

  Guidance Find() {
    const auto smallest = FindExcuses(ground_.task, SearchLimits());
    if (smallest.excuses.empty()) return {};
    for (const planning::Excuse& excuse : smallest.excuses) {
      guidance_.excuses.push_back(LiteralsOf(excuse));
    }
    const auto num_wishes = CountWishes(smallest.excuses.front());
    for (const planning::Excuse& excuse : smallest.excuses) {
      if (CountWishes(excuse) == num_wishes) {
        Add(excuse);
      } else {
        guidance_.further_excuses.push_back(LiteralsOf(excuse));
      }
    }
    if (num_wishes > 0) AddSuspects();
    for (const planning::Literal& l : smallest.excuses.front().subgoals) {
      guidance_.subgoals.push_back(LiteralOf(l, ground_));
    }
    return std::move(guidance_);
  }

 private:
  std::vector<Literal> LiteralsOf(const planning::Excuse& excuse) const {
    std::vector<Literal> literals;
    for (const auto& change : excuse.changes) {
      literals.push_back(LiteralOf(change.literal, ground_));
    }
    return literals;
  }

  bool IsWished(const planning::Literal& literal) const {
    return std::ranges::find(goal_, LiteralOf(literal, ground_)) != goal_.end();
  }

  int64_t CountWishes(const planning::Excuse& excuse) const {
    return std::ranges::count_if(excuse.changes, [this](const auto& change) {
      return IsWished(change.literal);
    });
  }

  void Add(const planning::Excuse& excuse) {
    for (const auto& change : excuse.changes) {
      AddChange(change, ground_, goal_, &guidance_);
    }
  }

  /// Preconditions that keep actions from being done which would help.
  void AddSuspects() {
    planning::ExcuseOptions options = SearchLimits();
    options.max_changes = 2;
    options.may_change = [this](const planning::Literal& l) {
      return !IsWished(l);
    };
    for (const auto& excuse : FindExcuses(ground_.task, options).excuses) {
      Add(excuse);
    }
  }

  const RuleTask& ground_;
  const std::vector<Literal>& goal_;
  Guidance guidance_;
};

}  // namespace

Guidance FindGuidance(const NdrRules& rules, const RexdTask& task,
                      const WorldState& state,
                      const std::vector<GroundAct>& acts) {
  const auto ground = GroundRuleTask(rules, task, state, acts);
  return ground ? GuidanceFinder(*ground, task.goal).Find() : Guidance{};
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
  for (const auto& excuse : guidance.further_excuses) {
    text += "It would also do if ";
    for (size_t i = 0; i < excuse.size(); ++i) {
      text += (i == 0 ? "" : " and ") + Show(excuse[i], world);
    }
    text += ".\n";
  }
  return text;
}

}  // namespace cell::rexd
