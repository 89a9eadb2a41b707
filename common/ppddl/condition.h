#pragma once

#include <string>
#include <vector>

namespace cell::ppddl {

/// A variable, "?x" with its question mark, and the type of its objects.
struct Variable {
  std::string name;
  int type = 0;  ///< index among the domain's types
  bool operator==(const Variable&) const = default;
};

/// An argument: a variable or an object.
struct Term {
  bool is_variable = false;
  /// Of a variable its place in the scope: first the action's parameters, then
  /// those of the enclosing quantifiers from the outermost. Of an object its
  /// place among the domain's constants followed by the problem's objects.
  int index = 0;
  bool operator==(const Term&) const = default;
};

/// A formula over the atoms of a state.
struct Condition {
  enum class Kind {
    kAtom,    ///< predicate and terms
    kEqual,   ///< two terms
    kNot,     ///< of the one part
    kAnd,     ///< of no parts: true
    kOr,      ///< of no parts: false
    kImply,   ///< the first part implies the second
    kForall,  ///< variables, one part
    kExists   ///< variables, one part
  };
  Kind kind = Kind::kAnd;
  int predicate = 0;
  std::vector<Term> terms;
  std::vector<Variable> variables;
  std::vector<Condition> parts;
  bool operator==(const Condition&) const = default;
};

}  // namespace cell::ppddl
