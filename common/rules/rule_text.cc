#include "common/rules/rule_text.h"

#include <fmt/format.h>

namespace cell::rules {
namespace {

const char* SignOf(Comparison comparison) {
  switch (comparison) {
    case Comparison::kNotEqual:
    case Comparison::kFalse:
      return "!=";
    case Comparison::kAtMost:
      return "<=";
    case Comparison::kAtLeast:
      return ">=";
    case Comparison::kEqual:
    case Comparison::kTrue:
      break;
  }
  return "=";
}

std::string TermText(const Term& term, const Rule& rule,
                     const SymbolTable& symbols) {
  switch (term.kind) {
    case Term::Kind::kVariable:
      return rule.VariableName(term.index);
    case Term::Kind::kObject:
      return symbols.constants().at(static_cast<size_t>(term.index));
    case Term::Kind::kAny:
      break;
  }
  return "_";
}

std::string ListText(const std::vector<Literal>& literals, const Rule& rule,
                     const SymbolTable& symbols, const char* empty) {
  std::string text;
  for (const Literal& literal : literals) {
    text += (text.empty() ? "" : ", ") + ToText(literal, rule, symbols);
  }
  return text.empty() ? empty : text;
}

std::string EachText(const QuantifiedChange& each, const Rule& rule,
                     const SymbolTable& symbols) {
  const Rule scope = rule.WithVariable(each.variable);
  std::string text = fmt::format("    each {}: {}", each.variable,
                                 ToText(each.change, scope, symbols));
  if (!each.where.empty()) {
    text += " if " + ListText(each.where, scope, symbols, "");
  }
  return text + "\n";
}

std::string ProbabilityText(double probability, int num_digits) {
  return num_digits == 0 ? fmt::format("{}", probability)
                         : fmt::format("{:.{}f}", probability, num_digits);
}

}  // namespace

std::string ToText(const Literal& literal, const Rule& rule,
                   const SymbolTable& symbols) {
  if (literal.symbol == Literal::kSame) {
    return fmt::format("{} {} {}", TermText(literal.terms[0], rule, symbols),
                       SignOf(literal.comparison),
                       TermText(literal.terms[1], rule, symbols));
  }
  const Symbol& symbol = symbols[literal.symbol];
  std::string text = literal.comparison == Comparison::kFalse ? "not " : "";
  text += symbol.name + "(";
  for (size_t i = 0; i < literal.terms.size(); ++i) {
    text += (i > 0 ? ", " : "") + TermText(literal.terms[i], rule, symbols);
  }
  text += ")";
  if (!symbol.is_integer) return text;
  return fmt::format("{} {} {}", text, SignOf(literal.comparison),
                     literal.value);
}

std::string ToText(const Rule& rule, const SymbolTable& symbols,
                   int num_digits) {
  std::string arguments;
  for (const std::string& name : rule.arguments) {
    arguments += (arguments.empty() ? "" : ", ") + name;
  }
  std::string text =
      fmt::format("Action: {}({})\n", symbols[rule.action].name, arguments);
  for (const Reference& reference : rule.references) {
    text += &reference == rule.references.data() ? "References: " : "; ";
    text += reference.variable + ": " +
            ListText(reference.literals, rule, symbols, "");
  }
  if (!rule.references.empty()) text += "\n";
  text += "Preconditions: " + ListText(rule.context, rule, symbols, "none") +
          "\nEffects:\n";
  for (const Outcome& outcome : rule.outcomes) {
    text += fmt::format("  {}: {}\n",
                        ProbabilityText(outcome.probability, num_digits),
                        ListText(outcome.changes, rule, symbols, "nothing"));
    for (const QuantifiedChange& each : outcome.each) {
      text += EachText(each, rule, symbols);
    }
  }
  return text +
         fmt::format("  {}: noise\n", ProbabilityText(rule.noise, num_digits));
}

std::string ToText(const NdrRules& rules) {
  std::string text = rules.symbols->ToText();
  for (const Rule& rule : rules.rules) {
    text += "\n" + ToText(rule, *rules.symbols);
  }
  return text;
}

}  // namespace cell::rules
