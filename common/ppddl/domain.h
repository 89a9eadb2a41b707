#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/ppddl/condition.h"
#include "common/ppddl/effect.h"

namespace cell::ppddl {

/// The type 0 is `object`, its own parent; parents are never in a cycle.
struct Type {
  std::string name;
  int parent = 0;
  bool operator==(const Type&) const = default;
};

struct Object {
  std::string name;
  int type = 0;
  bool operator==(const Object&) const = default;
};

/// A predicate or a function and its parameters.
struct Symbol {
  std::string name;
  std::vector<Variable> parameters;
  bool operator==(const Symbol&) const = default;
};

struct Action {
  std::string name;
  std::vector<Variable> parameters;
  Condition precondition;
  Effect effect;
  bool operator==(const Action&) const = default;
};

/// A PPDDL domain, all names resolved.
struct Domain {
  std::string name;
  std::vector<std::string> requirements;  ///< ":typing"
  std::vector<Type> types = {{"object", 0}};
  std::vector<Object> constants;
  std::vector<Symbol> predicates;
  /// total-cost and reward are there also if the text does not declare them.
  std::vector<Symbol> functions;
  std::vector<Action> actions;
  bool operator==(const Domain&) const = default;

  /// True if `type` is `ancestor` or below it.
  bool IsA(int type, int ancestor) const;
};

/// @param file  names the text in errors
/// @throws PpddlError
Domain ParseDomain(std::string_view text, const std::string& file);

/// The domain as PPDDL; ParseDomain() makes an equal one of it.
std::string ToText(const Domain& domain);

}  // namespace cell::ppddl
