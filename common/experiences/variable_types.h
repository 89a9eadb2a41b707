#pragma once

#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/rule.h"

namespace cell {

/// What the types of a task say of one variable of a rule.
class VariableTypes {
 public:
  VariableTypes(const RuleWorld& world, int variable)
      : world_(world), variable_(variable) {}

  bool IsObjectOf(int object, int type) const;
  /// The object's own type.
  int TypeOf(int object) const;
  bool IsA(int type, int ancestor) const {
    return hierarchy().IsA(type, ancestor);
  }
  /// The narrowest type of all the objects.
  int CommonType(const std::vector<int>& objects) const;
  bool IsNamedBy(const rules::Literal& literal) const;
  /// True if the literal says that the variable is of the type.
  bool Says(const rules::Literal& literal, int type) const;
  /// The type that the literal wants of the variable; object if it names none.
  int Wanted(const rules::Literal& literal) const;
  /// The variable's type by a change and conditions.
  int TypeBy(const rules::Literal& change,
             const std::vector<rules::Literal>& where) const;
  /// True if all literals are defined for all objects of that type.
  bool AreDefined(const rules::Literal& change,
                  const std::vector<rules::Literal>& where) const;

 private:
  const TypeHierarchy& hierarchy() const { return world_.vocabulary().types(); }
  int Narrower(int a, int b) const { return IsA(b, a) ? b : a; }
  int NamedType(const rules::Literal& literal) const;

  const RuleWorld& world_;
  int variable_;
};

}  // namespace cell
