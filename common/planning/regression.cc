#include "common/planning/regression.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace cell::planning {

Regression::Regression(const CausalGraph& graph,
                       const std::vector<Literal>& added)
    : graph_(graph), layer_(graph.num_literals(), -1) {
  const std::vector<bool>& initial = graph.task().initial;
  for (size_t atom = 0; atom < initial.size(); ++atom) {
    const Literal literal{static_cast<int>(atom), initial[atom]};
    layer_[CausalGraph::Index(literal)] = 0;
  }
  for (const Literal& l : added) layer_[CausalGraph::Index(l)] = 0;
  std::vector<const CausalGraph::Rule*> waiting;
  for (const auto& rule : graph.rules()) waiting.push_back(&rule);
  for (int layer = 1; true; ++layer) {
    std::vector<Literal> reached;
    std::erase_if(waiting, [&](const CausalGraph::Rule* rule) {
      const bool is_reached = std::ranges::all_of(
          rule->conditions, [&](const Conjunction* c) { return Has(*c); });
      if (!is_reached) return false;
      for (const Literal& l : *rule->then) {
        if (!Has(l)) reached.push_back(l);
      }
      return true;
    });
    if (reached.empty()) return;
    for (const Literal& l : reached) layer_[CausalGraph::Index(l)] = layer;
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
      graph_.task().goals,
      [this](const Conjunction& goal) { return Has(goal); });
}

std::vector<Regression::Literals> Regression::MissingOf(
    const Conjunction& condition) const {
  std::vector<Literals> missing;
  for (const Literal& l : condition.literals) {
    if (!Has(l)) missing.push_back({l});
  }
  for (const auto& clause : condition.clauses) {
    const bool is_reached = std::ranges::any_of(
        clause, [this](const Literal& l) { return Has(l); });
    if (!is_reached) missing.push_back(clause);
  }
  return missing;
}

Regression::Literals Regression::NextOf(
    const CausalGraph::Rule& rule, const std::vector<bool>& is_seen) const {
  Literals next;
  size_t fewest = 0;
  for (const Conjunction* condition : rule.conditions) {
    for (const Literals& literals : MissingOf(*condition)) {
      size_t number = 1;
      for (const Literal& l : literals) {
        if (is_seen[CausalGraph::Index(l)]) continue;
        number += 1 + graph_.ProducersOf(l).size();
      }
      if (!next.empty() && number >= fewest) continue;
      next = literals;
      fewest = number;
    }
  }
  return next;
}

Regression::Literals Regression::Regress(const Literals& wanted) const {
  Literals literals;
  std::vector<bool> is_seen(graph_.num_literals());
  const auto add = [&](const Literals& more) {
    for (const Literal& l : more) {
      const size_t index = CausalGraph::Index(l);
      if (!is_seen[index]) literals.push_back(l);
      is_seen[index] = true;
    }
  };
  add(wanted);
  for (size_t i = 0; i < literals.size(); ++i) {
    for (const int rule : graph_.ProducersOf(literals[i])) {
      add(NextOf(graph_.rules()[static_cast<size_t>(rule)], is_seen));
    }
  }
  return literals;
}

Regression::Gap Regression::FindGap(
    const std::function<bool(const Literal&)>& may_add) const {
  Gap gap{{}, std::numeric_limits<int>::max()};
  for (const Conjunction& goal : graph_.task().goals) {
    std::vector<Literals> needed;
    for (const Literals& missing : MissingOf(goal)) {
      Literals literals = Regress(missing);
      std::erase_if(literals, [&](const Literal& l) { return !may_add(l); });
      needed.push_back(std::move(literals));
    }
    std::ranges::stable_sort(needed, {}, &Literals::size);
    if (needed.empty() || needed.front().empty()) continue;
    // What has no literal in common is added one by one.
    std::set<Literal> counted;
    int least = 0;
    for (const Literals& literals : needed) {
      const bool is_apart = std::ranges::none_of(
          literals, [&](const Literal& l) { return counted.contains(l); });
      if (!is_apart) continue;
      ++least;
      counted.insert(literals.begin(), literals.end());
    }
    gap.least_changes = std::min(gap.least_changes, least);
    for (const Literal& l : needed.front()) {
      if (std::ranges::find(gap.literals, l) == gap.literals.end()) {
        gap.literals.push_back(l);
      }
    }
  }
  return gap;
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
  for (const Conjunction& goal : graph_.task().goals) {
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
    for (const int index : graph_.ProducersOf(wanted)) {
      const auto& rule = graph_.rules()[static_cast<size_t>(index)];
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
