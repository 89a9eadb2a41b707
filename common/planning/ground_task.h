#pragma once

#include <string>
#include <vector>

namespace cell::planning {

/// An atom that has to be, or becomes, true or false.
struct Literal {
  int atom = 0;
  bool value = true;
  auto operator<=>(const Literal&) const = default;
};

/// Holds if all literals and at least one literal of each clause hold.
struct Conjunction {
  std::vector<Literal> literals;
  std::vector<std::vector<Literal>> clauses;
  bool operator==(const Conjunction&) const = default;
};

/// Literals that become true one after the other, of contradicting ones the
/// last, if `when` held before the action.
struct ConditionalEffect {
  Conjunction when;
  std::vector<Literal> then;
  bool operator==(const ConditionalEffect&) const = default;
};

struct Outcome {
  double probability = 0;
  std::vector<ConditionalEffect> effects;  ///< one after the other
  bool operator==(const Outcome&) const = default;
};

/// With what is left of the outcomes' probability nothing changes. Actions may
/// share a name: one that has several preconditions.
struct GroundAction {
  std::string name;  ///< "pick-up(a, b)"
  Conjunction precondition;
  std::vector<Outcome> outcomes;
  bool operator==(const GroundAction&) const = default;
};

struct GroundAtom {
  std::string predicate;
  std::vector<std::string> objects;
  bool operator==(const GroundAtom&) const = default;
};
/// "on(a, b)"
std::string Show(const GroundAtom& atom);
/// "not on(a, b)"
std::string Show(const Literal& literal, const std::vector<GroundAtom>& atoms);

/// A planning task without variables.
struct GroundTask {
  std::vector<GroundAtom> atoms;
  std::vector<bool> initial;  ///< of each atom
  std::vector<GroundAction> actions;
  /// Reached if one of them holds; if there is none, never.
  std::vector<Conjunction> goals;
  bool operator==(const GroundTask&) const = default;
};

}  // namespace cell::planning
