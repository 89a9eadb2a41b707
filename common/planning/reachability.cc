#include "common/planning/reachability.h"

#include <algorithm>
#include <utility>

namespace cell::planning {
namespace {

/// The condition without literals that always hold; all that can never hold
/// must have been left out before.
Conjunction Simplified(const Conjunction& condition,
                       const Reachability& reached) {
  Conjunction simple;
  for (const Literal& l : condition.literals) {
    if (!reached.IsConstant(l.atom)) simple.literals.push_back(l);
  }
  for (const auto& clause : condition.clauses) {
    std::vector<Literal> open;
    bool holds = false;
    for (const Literal& l : clause) {
      if (!reached.IsConstant(l.atom)) {
        open.push_back(l);
      } else {
        holds |= reached.Has(l);
      }
    }
    if (holds) continue;
    if (open.size() == 1) {
      simple.literals.push_back(open.front());
    } else {
      simple.clauses.push_back(std::move(open));
    }
  }
  return simple;
}

Outcome Simplified(const Outcome& outcome, const Reachability& reached) {
  Outcome simple{outcome.probability, {}};
  for (const ConditionalEffect& effect : outcome.effects) {
    if (!reached.Has(effect.when)) continue;
    ConditionalEffect kept{Simplified(effect.when, reached), {}};
    for (const Literal& l : effect.then) {
      if (!reached.IsConstant(l.atom)) kept.then.push_back(l);
    }
    if (!kept.then.empty()) simple.effects.push_back(std::move(kept));
  }
  return simple;
}

/// Calls visit(literal) for every literal of the task, to be changed.
template <class Visit>
void ForEachLiteral(GroundTask* task, Visit visit) {
  const auto visit_all = [&](Conjunction& condition) {
    for (Literal& l : condition.literals) visit(l);
    for (auto& clause : condition.clauses) {
      for (Literal& l : clause) visit(l);
    }
  };
  for (GroundAction& action : task->actions) {
    visit_all(action.precondition);
    for (Outcome& outcome : action.outcomes) {
      for (ConditionalEffect& effect : outcome.effects) {
        visit_all(effect.when);
        for (Literal& l : effect.then) visit(l);
      }
    }
  }
  for (Conjunction& goal : task->goals) visit_all(goal);
}

}  // namespace

Reachability::Reachability(const GroundTask& task)
    : has_(2 * task.atoms.size()) {
  for (size_t atom = 0; atom < task.atoms.size(); ++atom) {
    has_[Index({static_cast<int>(atom), task.initial[atom]})] = true;
  }
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const GroundAction& action : task.actions) {
      if (Has(action.precondition)) is_new |= AddEffectsOf(action);
    }
  }
}

bool Reachability::Has(const Conjunction& conjunction) const {
  const auto has = [this](const Literal& l) {
    return Has(l);
  };
  return std::ranges::all_of(conjunction.literals, has) &&
         std::ranges::all_of(conjunction.clauses, [&](const auto& clause) {
           return std::ranges::any_of(clause, has);
         });
}

bool Reachability::AddEffectsOf(const GroundAction& action) {
  bool is_new = false;
  for (const Outcome& outcome : action.outcomes) {
    for (const ConditionalEffect& effect : outcome.effects) {
      if (!Has(effect.when)) continue;
      for (const Literal& l : effect.then) {
        is_new |= !Has(l);
        has_[Index(l)] = true;
      }
    }
  }
  return is_new;
}

void RemoveUnreachable(GroundTask* task) {
  const Reachability reached(*task);
  std::vector<GroundAction> actions;
  for (const GroundAction& action : task->actions) {
    if (!reached.Has(action.precondition)) continue;
    GroundAction kept{
        action.name, Simplified(action.precondition, reached), {}};
    bool changes = false;
    for (const Outcome& outcome : action.outcomes) {
      kept.outcomes.push_back(Simplified(outcome, reached));
      changes |= !kept.outcomes.back().effects.empty();
    }
    if (changes) actions.push_back(std::move(kept));
  }
  std::vector<Conjunction> goals;
  for (const Conjunction& goal : task->goals) {
    if (reached.Has(goal)) goals.push_back(Simplified(goal, reached));
  }
  task->actions = std::move(actions);
  task->goals = std::move(goals);
}

void RemoveUnusedAtoms(GroundTask* task) {
  std::vector<bool> is_used(task->atoms.size());
  ForEachLiteral(
      task, [&](Literal& l) { is_used[static_cast<size_t>(l.atom)] = true; });
  std::vector<int> new_index(task->atoms.size());
  GroundTask kept;
  for (size_t atom = 0; atom < is_used.size(); ++atom) {
    if (!is_used[atom]) continue;
    new_index[atom] = static_cast<int>(kept.atoms.size());
    kept.atoms.push_back(std::move(task->atoms[atom]));
    kept.initial.push_back(task->initial[atom]);
  }
  ForEachLiteral(task, [&](Literal& l) {
    l.atom = new_index[static_cast<size_t>(l.atom)];
  });
  task->atoms = std::move(kept.atoms);
  task->initial = std::move(kept.initial);
}

}  // namespace cell::planning
