#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/relational/literal.h"

namespace cell {

/// What the moved part may touch.
struct Partner {
  enum class Kind {
    kRole,    ///< the object of a role; of a site the part that has it
    kObject,  ///< the table or a certain part
    kType     ///< any part of a type, but those in a role
  };
  Kind kind = Kind::kObject;
  size_t role = 0;   ///< kRole
  std::string name;  ///< kObject: of it; kType: of the type

  auto operator<=>(const Partner&) const = default;
};

/// An order of literals that depends on nothing but their content.
struct LiteralOrder {
  bool operator()(const Literal& a, const Literal& b) const;
};
using LiteralSet = std::set<Literal, LiteralOrder>;

/// What holds in a scene, said of the roles of a manipulation: the variables
/// of the literals are roles. What it does not mention does not matter.
struct SceneFacts {
  std::set<Partner> touch;  ///< the moved part touches them
  std::set<Partner> apart;  ///< it does not touch them
  LiteralSet where;         ///< these are true

  size_t size() const { return touch.size() + apart.size() + where.size(); }
  bool operator==(const SceneFacts&) const = default;
};

Literal Negated(Literal literal);
/// True if a term of the literal is the role.
bool Mentions(const Literal& literal, size_t role);

/// What both say.
SceneFacts Intersection(const SceneFacts& a, const SceneFacts& b);

/// For each role its new place; nullopt: the role is left out.
using RoleMap = std::vector<std::optional<size_t>>;
/// The same facts of the roles' new places, without those of a role that is
/// left out.
SceneFacts Renamed(const SceneFacts& facts, const RoleMap& places);
LiteralSet Renamed(const LiteralSet& literals, const RoleMap& places);

/// The literals of `before` whose negation is in `after`.
LiteralSet ChangedLiterals(const SceneFacts& before, const SceneFacts& after);
/// The partners that are touched in one of them and apart in the other.
std::set<Partner> ChangedPartners(const SceneFacts& before,
                                  const SceneFacts& after);

}  // namespace cell
