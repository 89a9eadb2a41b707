#include "common/planning/relaxation.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace cell::planning {
namespace {

int FactOf(const Literal& literal) {
  return 2 * literal.atom + (literal.value ? 1 : 0);
}

}  // namespace

Relaxation::Lists Relaxation::Flatten(
    const std::vector<std::vector<int>>& lists) {
  Lists flat;
  for (const auto& list : lists) {
    flat.begin.push_back(static_cast<int>(flat.items.size()));
    flat.items.insert(flat.items.end(), list.begin(), list.end());
  }
  flat.begin.push_back(static_cast<int>(flat.items.size()));
  return flat;
}

Relaxation::Relaxation(const GroundTask& task)
    : num_atoms_(static_cast<int>(task.atoms.size())),
      num_facts_(2 * num_atoms_) {
  for (const GroundAction& action : task.actions) AddOperators(action);
  const size_t first_goal = operators_.size();
  for (const Conjunction& goal : task.goals) {
    operators_.push_back(OperatorOf(goal));
  }
  goal_fact_ = num_facts_++;
  for (size_t i = first_goal; i < operators_.size(); ++i) {
    operators_[i].added = {goal_fact_};
  }
  Index();
}

int Relaxation::FactOfClause(const std::vector<Literal>& clause) {
  const auto [it, is_new] = fact_of_clause_.try_emplace(clause, num_facts_);
  if (is_new) {
    ++num_facts_;
    clauses_.emplace_back();
    for (const Literal& l : clause) clauses_.back().push_back(FactOf(l));
  }
  return it->second;
}

Relaxation::Operator Relaxation::OperatorOf(const Conjunction& condition) {
  std::set<int> facts;
  std::set<int> atoms;
  for (const Literal& l : condition.literals) {
    facts.insert(FactOf(l));
    atoms.insert(l.atom);
  }
  for (const auto& clause : condition.clauses) {
    facts.insert(FactOfClause(clause));
    for (const Literal& l : clause) atoms.insert(l.atom);
  }
  return {{facts.begin(), facts.end()}, {atoms.begin(), atoms.end()}, {}};
}

void Relaxation::AddOperators(const GroundAction& action) {
  std::map<std::vector<int>, Operator> by_facts;
  for (const Outcome& outcome : action.outcomes) {
    for (const ConditionalEffect& effect : outcome.effects) {
      Conjunction both = action.precondition;
      both.literals.insert(both.literals.end(), effect.when.literals.begin(),
                           effect.when.literals.end());
      both.clauses.insert(both.clauses.end(), effect.when.clauses.begin(),
                          effect.when.clauses.end());
      Operator op = OperatorOf(both);
      Operator& joint = by_facts.try_emplace(op.facts, op).first->second;
      for (const Literal& l : effect.then) {
        if (std::ranges::find(joint.added, FactOf(l)) == joint.added.end()) {
          joint.added.push_back(FactOf(l));
        }
      }
    }
  }
  for (auto& [facts, op] : by_facts) operators_.push_back(std::move(op));
}

void Relaxation::MarkNeeded(const std::vector<std::vector<int>>& needing,
                            const std::vector<std::vector<int>>& clauses) {
  for (size_t fact = 0; fact < needing.size(); ++fact) {
    is_needed_.push_back(!needing[fact].empty() || !clauses[fact].empty());
  }
  is_needed_[static_cast<size_t>(goal_fact_)] = 1;
  for (int atom = 0; atom < num_atoms_; ++atom) {
    const auto fact = static_cast<size_t>(2 * atom);
    if (is_needed_[fact] != 0 || is_needed_[fact + 1] != 0) {
      needed_atoms_.push_back(atom);
    }
  }
}

void Relaxation::Index() {
  const auto num_facts = static_cast<size_t>(num_facts_);
  std::vector<std::vector<int>> clauses(num_facts);
  for (const auto& [clause, fact] : fact_of_clause_) {
    for (const Literal& l : clause) {
      clauses[static_cast<size_t>(FactOf(l))].push_back(fact);
    }
  }
  std::vector<std::vector<int>> needing(num_facts);
  std::vector<std::vector<int>> changing(static_cast<size_t>(num_atoms_) + 1);
  std::vector<std::vector<int>> facts, added, atoms;
  for (size_t i = 0; i < operators_.size(); ++i) {
    const Operator& op = operators_[i];
    const int index = static_cast<int>(i);
    num_needed_.push_back(static_cast<int>(op.facts.size()));
    const bool needs_false = std::ranges::any_of(op.facts, [this](int fact) {
      return fact >= 2 * num_atoms_ || fact % 2 == 0;
    });
    if (needs_false) needing_false_.push_back(index);
    for (const int fact : op.facts) {
      needing[static_cast<size_t>(fact)].push_back(index);
    }
    for (const int fact : op.added) {
      const int atom = fact == goal_fact_ ? num_atoms_ : fact / 2;
      auto& list = changing[static_cast<size_t>(atom)];
      if (list.empty() || list.back() != index) list.push_back(index);
    }
    facts.push_back(op.facts);
    atoms.push_back(op.atoms);
    if (op.facts.empty()) always_.push_back(index);
  }
  MarkNeeded(needing, clauses);
  for (const Operator& op : operators_) {
    added.emplace_back();
    std::ranges::copy_if(op.added, std::back_inserter(added.back()),
                         [this](int fact) {
                           return is_needed_[static_cast<size_t>(fact)] != 0;
                         });
  }
  indices_.clauses_with = Flatten(clauses);
  indices_.operators_needing = Flatten(needing);
  indices_.operators_changing = Flatten(changing);
  indices_.facts_of = Flatten(facts);
  indices_.added_by = Flatten(added);
  indices_.atoms_of = Flatten(atoms);
  operators_.clear();
  last_.cost.resize(num_facts);
}

inline void Relaxation::ReachOne(int fact, int layer, double cost) const {
  const auto index = static_cast<size_t>(fact);
  if (last_.layer[index] >= 0) return;
  last_.layer[index] = layer;
  last_.cost[index] = cost;
  last_.queue.push_back(fact);
}

inline void Relaxation::Reach(int fact, int layer, double cost) const {
  ReachOne(fact, layer, cost);
  if (clauses_.empty()) return;
  for (const int clause : indices_.clauses_with.Of(fact))
    ReachOne(clause, layer, cost);
}

inline void Relaxation::Fire(int op, int layer) const {
  const double cost = 1 + last_.operator_cost[static_cast<size_t>(op)];
  for (const int fact : indices_.added_by.Of(op)) Reach(fact, layer, cost);
}

void Relaxation::ReachAll(Bits state) const {
  last_.num_missing = num_needed_;
  last_.operator_cost.assign(num_needed_.size(), 0);
  last_.layer.assign(static_cast<size_t>(num_facts_), -1);
  last_.queue.clear();
  for (const int atom : needed_atoms_) {
    const bool value =
        (state[static_cast<size_t>(atom / 64)] >> (atom % 64) & 1) != 0;
    const int fact = FactOf({atom, value});
    if (is_needed_[static_cast<size_t>(fact)] != 0) Reach(fact, 0, 0);
  }
  for (const int op : always_) Fire(op, 1);
  for (size_t i = 0; i < last_.queue.size(); ++i) {
    const int fact = last_.queue[i];
    const int layer = last_.layer[static_cast<size_t>(fact)];
    const double cost = last_.cost[static_cast<size_t>(fact)];
    for (const int op : indices_.operators_needing.Of(fact)) {
      last_.operator_cost[static_cast<size_t>(op)] += cost;
      if (--last_.num_missing[static_cast<size_t>(op)] == 0)
        Fire(op, layer + 1);
    }
  }
}

void Relaxation::MarkRelevant() const {
  last_.is_seen.assign(num_needed_.size(), 0);
  last_.queue.clear();
  last_.queue.push_back(num_atoms_);  // the goal
  for (size_t i = 0; i < last_.queue.size(); ++i) {
    for (const int op : indices_.operators_changing.Of(last_.queue[i])) {
      char& is_seen = last_.is_seen[static_cast<size_t>(op)];
      if (is_seen != 0 || last_.num_missing[static_cast<size_t>(op)] > 0)
        continue;
      is_seen = 1;
      for (const int atom : indices_.atoms_of.Of(op)) {
        uint64_t& word = last_.relevant[static_cast<size_t>(atom / 64)];
        const uint64_t bit = uint64_t{1} << (atom % 64);
        if ((word & bit) != 0) continue;
        word |= bit;
        last_.queue.push_back(atom);
      }
    }
  }
}

void Relaxation::Keep(int fact) const {
  if (fact >= 2 * num_atoms_) {
    for (const int literal :
         clauses_[static_cast<size_t>(fact - 2 * num_atoms_)]) {
      Keep(literal);
    }
    return;
  }
  const int atom = fact / 2;
  last_.relevant[static_cast<size_t>(atom / 64)] |= uint64_t{1} << (atom % 64);
}

void Relaxation::KeepBlocked() const {
  for (const int op : needing_false_) {
    if (last_.num_missing[static_cast<size_t>(op)] == 0) continue;
    int blocking = -1;
    bool is_blocked_anyway = false;
    for (const int fact : indices_.facts_of.Of(op)) {
      if (last_.layer[static_cast<size_t>(fact)] >= 0) continue;
      const bool needs_true = fact < 2 * num_atoms_ && fact % 2 == 1;
      is_blocked_anyway |= needs_true;
      if (blocking < 0) blocking = fact;
    }
    if (!is_blocked_anyway) Keep(blocking);
  }
}

Estimate Relaxation::Assess(std::span<uint64_t> state) const {
  ReachAll(state);
  const auto goal = static_cast<size_t>(goal_fact_);
  if (last_.layer[goal] < 0) return {0, 0, 0};
  // The goal is an operator of its own, which costs nothing.
  const Estimate estimate{1, last_.layer[goal] - 1.0, last_.cost[goal] - 1};
  last_.relevant.assign(state.size(), 0);
  MarkRelevant();
  KeepBlocked();
  for (size_t i = 0; i < state.size(); ++i) state[i] &= last_.relevant[i];
  return estimate;
}

}  // namespace cell::planning
