#include <set>
#include <string>

#include "common/ppddl/parse_formula.h"

namespace cell::ppddl {
namespace {

void RefuseNumeric(const Expression& expression) {
  static const std::set<std::string> kComparisons = {"<", "<=", ">", ">="};
  if (kComparisons.contains(expression.Head())) {
    expression.Fail("numeric conditions (:fluents) are not supported");
  }
}

std::vector<Condition> PartsOf(const Expression& expression, Scope& scope) {
  std::vector<Condition> parts;
  for (size_t i = 1; i < expression.items.size(); ++i) {
    parts.push_back(ParseCondition(expression.items[i], scope));
  }
  return parts;
}

Condition ParseQuantified(const Expression& expression, Scope& scope,
                          Condition::Kind kind) {
  const std::string& head = expression.Head();
  if (expression.items.size() != 3 || !expression.items[1].is_list) {
    expression.Fail("write (" + head + " (?x - type) condition)");
  }
  Condition condition{kind};
  condition.variables = ReadVariables(expression.items[1], 0, scope);
  scope.AddVariables(condition.variables);
  condition.parts.push_back(ParseCondition(expression.items[2], scope));
  scope.RemoveVariables(condition.variables.size());
  return condition;
}

Condition ParseEqual(const Expression& expression, const Scope& scope) {
  if (expression.items.size() != 3) expression.Fail("write (= ?x ?y)");
  if (expression.items[1].is_list) {
    expression.Fail("numeric conditions (:fluents) are not supported");
  }
  Condition condition{Condition::Kind::kEqual};
  condition.terms = {scope.TermOf(expression.items[1]),
                     scope.TermOf(expression.items[2])};
  return condition;
}

Condition ParseAtom(const Expression& expression, const Scope& scope) {
  RefuseNumeric(expression);
  Condition condition{Condition::Kind::kAtom};
  condition.predicate = scope.PredicateOf(expression.items.front());
  condition.terms = scope.ArgumentsOf(
      expression,
      scope.domain().predicates[static_cast<size_t>(condition.predicate)]);
  return condition;
}

}  // namespace

Condition ParseCondition(const Expression& expression, Scope& scope) {
  if (!expression.is_list) {
    expression.Fail("'" + expression.word + "' is no condition; write (" +
                    expression.word + ")");
  }
  if (expression.items.empty()) return {};
  const std::string& head = expression.Head();
  using enum Condition::Kind;
  if (head == "and") return {kAnd, 0, {}, {}, PartsOf(expression, scope)};
  if (head == "or") return {kOr, 0, {}, {}, PartsOf(expression, scope)};
  if (head == "not") {
    Expect(expression, "not", 1, "(not condition)");
    return {kNot, 0, {}, {}, PartsOf(expression, scope)};
  }
  if (head == "imply") {
    Expect(expression, "imply", 2, "(imply condition condition)");
    return {kImply, 0, {}, {}, PartsOf(expression, scope)};
  }
  if (head == "forall") return ParseQuantified(expression, scope, kForall);
  if (head == "exists") return ParseQuantified(expression, scope, kExists);
  if (head == "=") return ParseEqual(expression, scope);
  return ParseAtom(expression, scope);
}

}  // namespace cell::ppddl
