#include "common/planning/alternatives.h"

#include <algorithm>
#include <utility>

namespace cell::planning {
namespace {

template <class T>
void AddOnce(std::vector<T>& list, const T& element) {
  if (std::ranges::find(list, element) == list.end()) list.push_back(element);
}

bool Contradicts(const Conjunction& conjunction) {
  return std::ranges::any_of(conjunction.literals, [&](const Literal& l) {
    return std::ranges::find(conjunction.literals, Literal{l.atom, !l.value}) !=
           conjunction.literals.end();
  });
}

/// The literals of which one has to hold, if nothing else does.
std::vector<Literal> AsClause(const Alternatives& alternatives) {
  if (alternatives.size() != 1) return {};
  const Conjunction& only = alternatives.front();
  if (only.literals.size() == 1 && only.clauses.empty()) return only.literals;
  if (only.literals.empty() && only.clauses.size() == 1) {
    return only.clauses.front();
  }
  return {};
}

/// True if one of the literals holds whatever the state.
bool IsCertain(const std::vector<Literal>& clause) {
  return std::ranges::any_of(clause, [&](const Literal& l) {
    return std::ranges::find(clause, Literal{l.atom, !l.value}) != clause.end();
  });
}

}  // namespace

Alternatives True() {
  return {Conjunction{}};
}
Alternatives False() {
  return {};
}

Alternatives Both(const Alternatives& a, const Alternatives& b) {
  Alternatives both;
  for (const Conjunction& left : a) {
    for (const Conjunction& right : b) {
      Conjunction joint = left;
      for (const Literal& l : right.literals) AddOnce(joint.literals, l);
      for (const auto& clause : right.clauses) AddOnce(joint.clauses, clause);
      if (!Contradicts(joint)) both.push_back(std::move(joint));
    }
  }
  return both;
}

Alternatives Either(Alternatives a, const Alternatives& b) {
  const std::vector<Literal> left = AsClause(a);
  const std::vector<Literal> right = AsClause(b);
  if (left.empty() || right.empty()) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
  std::vector<Literal> clause = left;
  for (const Literal& l : right) AddOnce(clause, l);
  if (IsCertain(clause)) return True();
  if (clause.size() == 1) return {Conjunction{clause, {}}};
  return {Conjunction{{}, {clause}}};
}

Alternatives Neither(const Alternatives& alternatives) {
  Alternatives none = True();
  for (const Conjunction& conjunction : alternatives) {
    Alternatives broken;
    const auto add = [&](Alternatives one) {
      broken = broken.empty() ? std::move(one) : Either(std::move(broken), one);
    };
    for (const Literal& l : conjunction.literals) {
      add({Conjunction{{{l.atom, !l.value}}, {}}});
    }
    for (const auto& clause : conjunction.clauses) {
      Conjunction all_false;
      for (const Literal& l : clause) {
        all_false.literals.push_back({l.atom, !l.value});
      }
      add({all_false});
    }
    none = Both(none, broken);
  }
  return none;
}

}  // namespace cell::planning
