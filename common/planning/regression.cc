#include "common/planning/regression.h"

#include <algorithm>

namespace cell::planning {

Regression::Regression(const GroundTask& task,
                       const std::vector<Literal>& added)
    : task_(task), layer_(2 * task.atoms.size(), -1) {
  for (const GroundAction& action : task.actions) {
    for (const Outcome& outcome : action.outcomes) {
      for (const ConditionalEffect& effect : outcome.effects) {
        rules_.push_back({{&action.precondition, &effect.when}, &effect.then});
      }
    }
  }
  for (size_t atom = 0; atom < task.atoms.size(); ++atom) {
    layer_[Index({static_cast<int>(atom), task.initial[atom]})] = 0;
  }
  for (const Literal& l : added) layer_[Index(l)] = 0;
  for (int layer = 1; true; ++layer) {
    std::vector<Literal> reached;
    for (const Rule& rule : rules_) {
      const bool is_reached = std::ranges::all_of(
          rule.conditions, [&](const Conjunction* c) { return Has(*c); });
      if (!is_reached) continue;
      for (const Literal& l : *rule.then) {
        if (!Has(l)) reached.push_back(l);
      }
    }
    if (reached.empty()) return;
    for (const Literal& l : reached) layer_[Index(l)] = layer;
  }
}

int Regression::LayerOf(const Conjunction& condition) const {
  int last = 0;
  for (const Literal& l : condition.literals) {
    if (!Has(l)) return -1;
    last = std::max(last, LayerOf(l));
  }
  for (const auto& clause : condition.clauses) {
    int first = -1;
    for (const Literal& l : clause) {
      if (Has(l) && (first < 0 || LayerOf(l) < first)) first = LayerOf(l);
    }
    if (first < 0) return -1;
    last = std::max(last, first);
  }
  return last;
}

bool Regression::Has(const Conjunction& condition) const {
  return LayerOf(condition) >= 0;
}

bool Regression::HasGoal() const {
  return std::ranges::any_of(
      task_.goals, [this](const Conjunction& goal) { return Has(goal); });
}

void Regression::AddMissing(const Conjunction& condition,
                            std::vector<Literal>* missing) const {
  const auto add = [&](const Literal& l) {
    if (!Has(l) && std::ranges::find(*missing, l) == missing->end()) {
      missing->push_back(l);
    }
  };
  for (const Literal& l : condition.literals) add(l);
  for (const auto& clause : condition.clauses) {
    const bool is_reached = std::ranges::any_of(
        clause, [this](const Literal& l) { return Has(l); });
    if (!is_reached) std::ranges::for_each(clause, add);
  }
}

std::vector<Literal> Regression::Missing() const {
  std::vector<Literal> missing;
  if (HasGoal()) return missing;
  for (const Conjunction& goal : task_.goals) AddMissing(goal, &missing);
  for (size_t i = 0; i < missing.size(); ++i) {
    const Literal wanted = missing[i];
    for (const Rule& rule : rules_) {
      if (std::ranges::find(*rule.then, wanted) == rule.then->end()) continue;
      for (const Conjunction* c : rule.conditions) AddMissing(*c, &missing);
    }
  }
  return missing;
}

std::vector<Literal> Regression::SupportOf(const Conjunction& condition) const {
  std::vector<Literal> support = condition.literals;
  for (const auto& clause : condition.clauses) {
    const Literal* first = nullptr;
    for (const Literal& l : clause) {
      if (Has(l) && (first == nullptr || LayerOf(l) < LayerOf(*first))) {
        first = &l;
      }
    }
    if (first != nullptr) support.push_back(*first);
  }
  return support;
}

std::vector<Literal> Regression::SubgoalsWithin(const Regression& base) const {
  std::vector<Literal> open;
  for (const Conjunction& goal : task_.goals) {
    if (!Has(goal)) continue;
    open = SupportOf(goal);
    break;
  }
  std::vector<Literal> subgoals;
  std::set<Literal> seen(open.begin(), open.end());
  for (size_t i = 0; i < open.size(); ++i) {
    const Literal wanted = open[i];
    if (base.Has(wanted)) {
      const Literal opposite{wanted.atom, !wanted.value};
      if (std::ranges::find(subgoals, opposite) == subgoals.end()) {
        subgoals.push_back(wanted);
      }
      continue;
    }
    for (const Rule& rule : rules_) {
      if (std::ranges::find(*rule.then, wanted) == rule.then->end()) continue;
      const bool is_earlier =
          std::ranges::all_of(rule.conditions, [&](const Conjunction* c) {
            return Has(*c) && LayerOf(*c) < LayerOf(wanted);
          });
      if (!is_earlier) continue;
      for (const Conjunction* c : rule.conditions) {
        for (const Literal& l : SupportOf(*c)) {
          if (seen.insert(l).second) open.push_back(l);
        }
      }
      break;
    }
  }
  return subgoals;
}

bool Regression::AppliesBy(const GroundAction& action,
                           const Literal& literal) const {
  const auto speaks = [&](const Conjunction& condition) {
    return std::ranges::find(condition.literals, literal) !=
               condition.literals.end() ||
           std::ranges::any_of(condition.clauses, [&](const auto& clause) {
             return std::ranges::find(clause, literal) != clause.end();
           });
  };
  if (!Has(action.precondition)) return false;
  if (speaks(action.precondition)) return true;
  for (const Outcome& outcome : action.outcomes) {
    for (const ConditionalEffect& effect : outcome.effects) {
      if (speaks(effect.when) && Has(effect.when)) return true;
    }
  }
  return false;
}

}  // namespace cell::planning
