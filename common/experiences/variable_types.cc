#include "common/experiences/variable_types.h"

#include <algorithm>

namespace cell {

bool VariableTypes::IsObjectOf(int object, int type) const {
  return world_.vocabulary().IsOf(world_.ObjectOf(object), type);
}

int VariableTypes::TypeOf(int object) const {
  const auto index = static_cast<size_t>(world_.ObjectOf(object));
  return world_.vocabulary().objects()[index].type;
}

int VariableTypes::CommonType(const std::vector<int>& objects) const {
  int common = TypeHierarchy::kObject;
  for (int type = 0; type < hierarchy().size(); ++type) {
    const bool is_common = std::ranges::all_of(
        objects, [&](int object) { return IsObjectOf(object, type); });
    if (is_common) common = Narrower(common, type);
  }
  return common;
}

bool VariableTypes::IsNamedBy(const rules::Literal& literal) const {
  return std::ranges::any_of(literal.terms, [&](const rules::Term& term) {
    return term.kind == rules::Term::Kind::kVariable && term.index == variable_;
  });
}

bool VariableTypes::Says(const rules::Literal& literal, int type) const {
  return literal.comparison == rules::Comparison::kTrue &&
         literal.terms.size() == 1 && IsNamedBy(literal) &&
         NamedType(literal) == type && type != TypeHierarchy::kObject;
}

int VariableTypes::Wanted(const rules::Literal& literal) const {
  int type = TypeHierarchy::kObject;
  const std::vector<int>& types = world_.ArgumentTypes(literal.symbol);
  for (size_t i = 0; i < literal.terms.size(); ++i) {
    const rules::Term& term = literal.terms[i];
    if (term.kind == rules::Term::Kind::kVariable && term.index == variable_) {
      type = Narrower(type, types[i]);
    }
  }
  return type;
}

int VariableTypes::TypeBy(const rules::Literal& change,
                          const std::vector<rules::Literal>& where) const {
  int type = Wanted(change);
  for (const rules::Literal& literal : where) {
    if (literal.comparison != rules::Comparison::kTrue) continue;
    type = Narrower(type, Wanted(literal));
    if (IsNamedBy(literal)) type = Narrower(type, NamedType(literal));
  }
  return type;
}

bool VariableTypes::AreDefined(const rules::Literal& change,
                               const std::vector<rules::Literal>& where) const {
  const int type = TypeBy(change, where);
  return std::ranges::all_of(where, [&](const rules::Literal& literal) {
    return IsA(type, Wanted(literal));
  });
}

/// The type that a predicate of one argument is named after; object if none.
int VariableTypes::NamedType(const rules::Literal& literal) const {
  const auto type =
      hierarchy().Find(world_.world()->symbols()[literal.symbol].name);
  return literal.terms.size() == 1 && type ? *type : TypeHierarchy::kObject;
}

}  // namespace cell
