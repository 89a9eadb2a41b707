#include "common/rules/literal_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "common/rules/named_fact.h"
#include "common/rules/rule_text.h"
#include "common/text/nearest.h"

namespace cell::rules {
namespace {

/// The values that a comparison with a function's value allows: from, to.
std::pair<int, int> Range(const Literal& literal) {
  constexpr int kMin = std::numeric_limits<int>::min();
  constexpr int kMax = std::numeric_limits<int>::max();
  switch (literal.comparison) {
    case Comparison::kEqual:
      return {literal.value, literal.value};
    case Comparison::kAtMost:
      return {kMin, literal.value};
    case Comparison::kAtLeast:
      return {literal.value, kMax};
    default:
      return {kMin, kMax};
  }
}

/// True if `a` negates what `b` says, whatever the variables stand for.
bool Negates(const Literal& a, const Literal& b) {
  if (a.comparison == Comparison::kNotEqual) {
    return b.comparison == Comparison::kEqual && a.terms == b.terms &&
           a.value == b.value;
  }
  return a.comparison == Comparison::kFalse &&
         b.comparison == Comparison::kTrue &&
         std::ranges::equal(
             a.terms, b.terms, [](const Term& negated, const Term& term) {
               // `_` of the negated one: no object at all.
               return negated.kind == Term::Kind::kAny || negated == term;
             });
}

/// True if both never hold together.
bool Contradict(const Literal& a, const Literal& b) {
  if (a.symbol != b.symbol) return false;
  if (Negates(a, b) || Negates(b, a)) return true;
  const auto [a_from, a_to] = Range(a);
  const auto [b_from, b_to] = Range(b);
  return a.terms == b.terms && (a_from > b_to || b_from > a_to);
}

}  // namespace

std::vector<Literal> LiteralParser::ReadList(ListKind kind, const Rule& scope,
                                             TokenReader& in) const {
  std::vector<Literal> literals;
  do {
    Literal literal = Read(kind, scope, in);
    for (const Literal& other : literals) {
      if (!Contradict(literal, other)) continue;
      in.Fail(fmt::format(
          "'{}' contradicts '{}' of the same list: they never hold together",
          ToText(literal, scope, symbols()), ToText(other, scope, symbols())));
    }
    literals.push_back(std::move(literal));
  } while (in.TakeIf(","));
  return literals;
}

Literal LiteralParser::Read(ListKind kind, const Rule& scope,
                            TokenReader& in) const {
  Literal literal;
  const bool is_negated = in.TakeIf("not");
  if (in.Peek(1) != "(") return ReadSame(kind, is_negated, scope, in);
  const std::string name = in.Word("a predicate");
  literal.symbol = FactNamed(name, symbols(), in);
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
