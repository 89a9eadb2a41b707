#include "common/rules/literal_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "common/text/nearest.h"

namespace cell::rules {

std::vector<Literal> LiteralParser::ReadList(ListKind kind, const Rule& scope,
                                             TokenReader& in) const {
  std::vector<Literal> literals;
  do {
    literals.push_back(Read(kind, scope, in));
  } while (in.TakeIf(","));
  return literals;
}

Literal LiteralParser::Read(ListKind kind, const Rule& scope,
                            TokenReader& in) const {
  Literal literal;
  const bool is_negated = in.TakeIf("not");
  if (in.Peek(1) != "(") return ReadSame(kind, is_negated, scope, in);
  const std::string name = in.Word("a predicate");
  const auto symbol = symbols().Find(name);
  if (!symbol || symbols()[*symbol].kind == Symbol::Kind::kAction) {
    in.Fail(fmt::format(
        "there is no predicate or function '{}'{}", name,
        NamesInstead(name, NamesIn(symbols().all(), &Symbol::name))));
  }
  literal.symbol = *symbol;
  in.Expect("(");
  while (!in.TakeIf(")")) {
    literal.terms.push_back(ReadTerm(scope, in));
    if (in.Peek() != ")") in.Expect(",");
  }
  ReadComparison(is_negated, &literal, in);
  Check(literal, kind, in);
  return literal;
}

/// "X = Y", "X != c"
Literal LiteralParser::ReadSame(ListKind kind, bool is_negated,
                                const Rule& scope, TokenReader& in) const {
  Literal literal;
  literal.symbol = Literal::kSame;
  literal.terms.push_back(ReadTerm(scope, in));
  if (is_negated || kind == ListKind::kChanges) {
    in.Fail("expected a predicate: NAME(X, Y)");
  }
  if (in.TakeIf("!=")) {
    literal.comparison = Comparison::kFalse;
  } else {
    in.Expect("=");
  }
  literal.terms.push_back(ReadTerm(scope, in));
  return literal;
}

void LiteralParser::ReadComparison(bool is_negated, Literal* literal,
                                   TokenReader& in) const {
  const Symbol& symbol = symbols()[literal->symbol];
  literal->comparison = is_negated ? Comparison::kFalse : Comparison::kTrue;
  if (!symbol.is_integer) return;
  if (is_negated) in.Fail("a comparison has no 'not'");
  const std::pair<const char*, Comparison> signs[] = {
      {"=", Comparison::kEqual},
      {"!=", Comparison::kNotEqual},
      {"<=", Comparison::kAtMost},
      {">=", Comparison::kAtLeast}};
  for (const auto& [sign, comparison] : signs) {
    if (!in.TakeIf(sign)) continue;
    literal->comparison = comparison;
    literal->value = in.Integer("a whole number");
    return;
  }
  in.Fail(
      fmt::format("'{}' is a function: expected =, !=, <= or >= and a "
                  "number",
                  symbol.name));
}

void LiteralParser::Check(const Literal& literal, ListKind kind,
                          const TokenReader& in) const {
  const Symbol& symbol = symbols()[literal.symbol];
  if (static_cast<int>(literal.terms.size()) != symbol.arity) {
    in.Fail(fmt::format("'{}' has {} arguments, not {}", symbol.name,
                        symbol.arity, literal.terms.size()));
  }
  const bool has_any = std::ranges::any_of(
      literal.terms, [](const Term& t) { return t.kind == Term::Kind::kAny; });
  if (has_any && (symbol.is_integer || kind == ListKind::kChanges)) {
    in.Fail("'_' can stand in a condition on a predicate only");
  }
  if (kind == ListKind::kConditions) return;
  if (symbol.is_derived()) {
    in.Fail(
        fmt::format("'{}' is derived: no effect can change it", symbol.name));
  }
  if (symbol.is_integer && literal.comparison != Comparison::kEqual) {
    in.Fail("an effect gives a function a value: f(X) = 1");
  }
}

Term LiteralParser::ReadTerm(const Rule& scope, TokenReader& in) const {
  const std::string name = in.Word("a variable, a constant, or _");
  if (name == "_") return {Term::Kind::kAny, 0};
  if (IsVariableName(name)) {
    for (int i = 0; i < scope.num_variables(); ++i) {
      if (scope.VariableName(i) == name) {
        return {Term::Kind::kVariable, i};
      }
    }
    in.Fail(fmt::format("there is no variable '{}' in this rule", name));
  }
  const auto& constants = symbols().constants();
  const auto it = std::ranges::find(constants, name);
  if (it == constants.end()) {
    in.Fail(fmt::format("there is no constant '{}'{}", name,
                        NamesInstead(name, constants)));
  }
  return {Term::Kind::kObject, static_cast<int>(it - constants.begin())};
}

}  // namespace cell::rules
