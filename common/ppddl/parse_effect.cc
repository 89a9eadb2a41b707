#include <fmt/format.h>

#include <set>
#include <string>

#include "common/ppddl/parse_formula.h"

namespace cell::ppddl {
namespace {

constexpr double kSumTolerance = 1e-9;

Effect ParseChange(const Expression& expression, const Scope& scope,
                   Effect::Kind kind) {
  if (!expression.is_list || expression.items.empty()) {
    expression.Fail("an atom is missing, as (on ?x ?y)");
  }
  Effect effect{kind};
  effect.symbol = scope.PredicateOf(expression.items.front());
  effect.terms = scope.ArgumentsOf(
      expression,
      scope.domain().predicates[static_cast<size_t>(effect.symbol)]);
  return effect;
}

/// "(total-cost)", or the word alone.
int ParseFunction(const Expression& expression, const Scope& scope,
                  std::vector<Term>* terms) {
  if (!expression.is_list) return scope.FunctionOf(expression);
  if (expression.items.empty()) expression.Fail("a function is missing");
  const int function = scope.FunctionOf(expression.items.front());
  *terms = scope.ArgumentsOf(
      expression, scope.domain().functions[static_cast<size_t>(function)]);
  return function;
}

Effect ParseNumeric(const Expression& expression, const Scope& scope,
                    Effect::Kind kind) {
  if (expression.items.size() != 3) {
    expression.Fail("write (" + expression.Head() + " (function) number)");
  }
  Effect effect{kind};
  effect.symbol = ParseFunction(expression.items[1], scope, &effect.terms);
  const Expression& amount = expression.items[2];
  static const std::set<std::string> kOperators = {"+", "-", "*", "/"};
  if (amount.is_list && kOperators.contains(amount.Head())) {
    amount.Fail("arithmetic (:fluents) is not supported; write a number");
  }
  effect.amount.is_number = !amount.is_list;
  if (amount.is_list) {
    effect.amount.function = ParseFunction(amount, scope, &effect.amount.terms);
  } else {
    effect.amount.number = ReadNumber(amount, -kMaxNumber, kMaxNumber);
  }
  return effect;
}

Effect ParseProbabilistic(const Expression& expression, Scope& scope) {
  if (expression.items.size() % 2 == 0 || expression.items.size() < 3) {
    expression.Fail("write (probabilistic 0.3 effect 0.7 effect)");
  }
  Effect effect{Effect::Kind::kProbabilistic};
  double sum = 0;
  for (size_t i = 1; i < expression.items.size(); i += 2) {
    effect.probabilities.push_back(ReadNumber(expression.items[i], 0, 1));
    sum += effect.probabilities.back();
    if (sum > 1 + kSumTolerance) {
      expression.items[i].Fail(fmt::format(
          "the probabilities sum to {}; they must not exceed 1", sum));
    }
    effect.parts.push_back(ParseEffect(expression.items[i + 1], scope));
  }
  return effect;
}

Effect ParseForall(const Expression& expression, Scope& scope) {
  if (expression.items.size() != 3 || !expression.items[1].is_list) {
    expression.Fail("write (forall (?x - type) effect)");
  }
  Effect effect{Effect::Kind::kForall};
  effect.variables = ReadVariables(expression.items[1], 0, scope);
  scope.AddVariables(effect.variables);
  effect.parts.push_back(ParseEffect(expression.items[2], scope));
  scope.RemoveVariables(effect.variables.size());
  return effect;
}

Effect ParseWhen(const Expression& expression, Scope& scope) {
  Expect(expression, "when", 2, "(when condition effect)");
  Effect effect{Effect::Kind::kWhen};
  effect.condition = ParseCondition(expression.items[1], scope);
  effect.parts.push_back(ParseEffect(expression.items[2], scope));
  return effect;
}

}  // namespace

Effect ParseEffect(const Expression& expression, Scope& scope) {
  if (!expression.is_list) {
    expression.Fail("'" + expression.word + "' is no effect; write (" +
                    expression.word + ")");
  }
  if (expression.items.empty()) return {};
  const std::string& head = expression.Head();
  if (head == "and") {
    Effect effect;
    for (size_t i = 1; i < expression.items.size(); ++i) {
      effect.parts.push_back(ParseEffect(expression.items[i], scope));
    }
    return effect;
  }
  if (head == "not") {
    Expect(expression, "not", 1, "(not (atom))");
    return ParseChange(expression.items[1], scope, Effect::Kind::kDelete);
  }
  if (head == "when") return ParseWhen(expression, scope);
  if (head == "forall") return ParseForall(expression, scope);
  if (head == "probabilistic") return ParseProbabilistic(expression, scope);
  if (head == "increase") {
    return ParseNumeric(expression, scope, Effect::Kind::kIncrease);
  }
  if (head == "decrease") {
    return ParseNumeric(expression, scope, Effect::Kind::kDecrease);
  }
  if (head == "assign" || head == "scale-up" || head == "scale-down") {
    expression.Fail("'" + head + "' (:fluents) is not supported");
  }
  if (head == "oneof") {
    expression.Fail("'oneof' is not supported; give probabilities");
  }
  return ParseChange(expression, scope, Effect::Kind::kAdd);
}

}  // namespace cell::ppddl
