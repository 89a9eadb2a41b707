#include "common/rules/ppddl_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace cell::rules {
namespace {

std::string Lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

/// A name of PPDDL: it begins with a letter and has no dots.
std::string NameOf(const std::string& name) {
  std::string text = name;
  std::ranges::replace(text, '.', '-');
  return std::isalpha(static_cast<unsigned char>(text[0])) ? text : "o-" + text;
}

std::string VariableOf(const std::string& name) {
  return "?" + Lower(name);
}

bool IsUsed(const NdrRules& rules, int symbol) {
  const auto is_it = [&](const Literal& l) {
    return l.symbol == symbol;
  };
  for (const Rule& rule : rules.rules) {
    if (std::ranges::any_of(rule.context, is_it)) return true;
    for (const Outcome& outcome : rule.outcomes) {
      for (const QuantifiedChange& each : outcome.each) {
        if (std::ranges::any_of(each.where, is_it)) return true;
      }
    }
    for (const Reference& reference : rule.references) {
      if (std::ranges::any_of(reference.literals, is_it)) return true;
    }
  }
  return false;
}

/// Writes one domain.
class PpddlText {
 public:
  explicit PpddlText(const NdrRules& rules)
      : rules_(rules), symbols_(*rules.symbols) {}

  std::string Domain(const std::string& name) {
    std::string text = fmt::format(
        "(define (domain {})\n  (:requirements :adl "
        ":probabilistic-effects{}{})\n",
        NameOf(name), HasDerived() ? " :derived-predicates" : "",
        HasFunctions() ? " :fluents" : "");
    if (!symbols_.constants().empty()) {
      text += "  (:constants";
      for (const auto& constant : symbols_.constants()) {
        text += " " + NameOf(constant);
      }
      text += ")\n";
    }
    text += Declarations("predicates", false);
    text += Declarations("functions", true);
    for (const Symbol& symbol : symbols_.all()) text += Derived(symbol);
    for (const Rule& rule : rules_.rules) text += Action(rule);
    return text + ")\n";
  }

 private:
  bool HasDerived() const {
    return std::ranges::any_of(symbols_.all(), [](const Symbol& symbol) {
      return symbol.kind == Symbol::Kind::kConjunction ||
             symbol.kind == Symbol::Kind::kClosure;
    });
  }
  bool HasFunctions() const {
    return std::ranges::any_of(symbols_.all(), [](const Symbol& symbol) {
      return symbol.kind == Symbol::Kind::kPrimitive && symbol.is_integer;
    });
  }

  std::string Declarations(const char* section, bool is_integer) const {
    std::string text;
    for (const Symbol& symbol : symbols_.all()) {
      if (symbol.kind == Symbol::Kind::kAction ||
          symbol.kind == Symbol::Kind::kCount ||
          symbol.kind == Symbol::Kind::kSum ||
          symbol.is_integer != is_integer) {
        continue;
      }
      text += " (" + NameOf(symbol.name);
      for (int i = 0; i < symbol.arity; ++i) {
        text += " " +
                VariableOf(symbol.definition.variables[static_cast<size_t>(i)]);
      }
      text += ")";
    }
    return text.empty() ? "" : fmt::format("  (:{}{})\n", section, text);
  }

  std::string Derived(const Symbol& symbol) const {
    if (symbol.kind == Symbol::Kind::kClosure) {
      const std::string of = NameOf(symbols_[symbol.definition.of].name);
      const std::string name = NameOf(symbol.name);
      return fmt::format(
          "  (:derived ({0} ?x ?y)\n    (or ({1} ?x ?y) (exists (?z) (and ({1} "
          "?x ?z) ({0} ?z ?y)))))\n",
          name, of);
    }
    if (symbol.kind != Symbol::Kind::kConjunction) return "";
    std::string head = NameOf(symbol.name);
    const auto& variables = symbol.definition.variables;
    const auto arity = static_cast<size_t>(symbol.arity);
    for (size_t i = 0; i < arity; ++i) head += " " + VariableOf(variables[i]);
    std::string body = Conjunction(symbol.definition, variables);
    if (variables.size() > arity) {
      std::string quantified;
      for (size_t i = arity; i < variables.size(); ++i) {
        quantified += (i > arity ? " " : "") + VariableOf(variables[i]);
      }
      body = fmt::format("({} ({}) {})",
                         symbol.definition.is_for_all ? "forall" : "exists",
                         quantified, body);
    }
    return fmt::format("  (:derived ({})\n    {})\n", head, body);
  }

  std::string Conjunction(const Definition& definition,
                          const std::vector<std::string>& names) const {
    std::string text = "(and";
    for (const Definition::Atom& atom : definition.atoms) {
      std::string inner = "(" + NameOf(symbols_[atom.symbol].name);
      for (const int v : atom.variables) {
        inner += " " + VariableOf(names[static_cast<size_t>(v)]);
      }
      inner += ")";
      text += atom.is_negated ? " (not " + inner + ")" : " " + inner;
    }
    return text + ")";
  }

  std::string Action(const Rule& rule) {
    const Symbol& symbol = symbols_[rule.action];
    const int number = ++num_rules_[rule.action];
    std::string text = "  (:action " + NameOf(symbol.name);
    if (number > 1) text += fmt::format("_{}", number);
    text += "\n    :parameters (";
    for (int i = 0; i < rule.num_variables(); ++i) {
      text += (i > 0 ? " " : "") + VariableOf(rule.VariableName(i));
    }
    text += ")\n    :precondition (and";
    if (!symbol.definition.atoms.empty()) {
      text += " " + Conjunction(symbol.definition, rule.arguments);
    }
    for (size_t i = 0; i < rule.references.size(); ++i) {
      text += Unique(rule, static_cast<int>(rule.arguments.size() + i),
                     rule.references[i].literals);
    }
    for (const Literal& literal : rule.context) {
      text += " " + Condition(literal, rule, -1);
    }
    return text + ")\n    :effect " + Effect(rule) + ")\n";
  }

  /// The reference's literals hold of it, and of nothing else.
  std::string Unique(const Rule& rule, int variable,
                     const std::vector<Literal>& literals) const {
    std::string text;
    std::string others;
    for (const Literal& literal : literals) {
      text += " " + Condition(literal, rule, -1);
      others += " " + Condition(literal, rule, variable);
    }
    return fmt::format(
        "{}\n      (forall (?other) (imply (and{}) (= ?other {})))", text,
        others, VariableOf(rule.VariableName(variable)));
  }

  /// @param other  the variable that is written as ?other
  std::string TermText(const Term& term, const Rule& rule, int other) const {
    if (term.kind == Term::Kind::kObject) {
      return NameOf(symbols_.constants().at(static_cast<size_t>(term.index)));
    }
    if (term.index == other) return "?other";
    return VariableOf(rule.VariableName(term.index));
  }

  std::string Condition(const Literal& literal, const Rule& rule,
                        int other) const {
    const bool is_same = literal.symbol == Literal::kSame;
    std::string atom =
        is_same ? "(=" : "(" + NameOf(symbols_[literal.symbol].name);
    std::string quantified;
    for (size_t i = 0; i < literal.terms.size(); ++i) {
      if (literal.terms[i].kind == Term::Kind::kAny) {
        const std::string name = fmt::format("?any{}", i + 1);
        quantified += (quantified.empty() ? "" : " ") + name;
        atom += " " + name;
      } else {
        atom += " " + TermText(literal.terms[i], rule, other);
      }
    }
    atom += ")";
    if (!quantified.empty()) {
      atom = fmt::format("(exists ({}) {})", quantified, atom);
    }
    switch (literal.comparison) {
      case Comparison::kTrue:
        return atom;
      case Comparison::kFalse:
        return "(not " + atom + ")";
      case Comparison::kEqual:
        return fmt::format("(= {} {})", atom, literal.value);
      case Comparison::kNotEqual:
        return fmt::format("(not (= {} {}))", atom, literal.value);
      case Comparison::kAtMost:
        return fmt::format("(<= {} {})", atom, literal.value);
      case Comparison::kAtLeast:
        return fmt::format("(>= {} {})", atom, literal.value);
    }
    return atom;
  }

  std::string Change(const Literal& change, const Rule& rule) const {
    const std::string condition = Condition(change, rule, -1);
    return change.comparison == Comparison::kEqual
               ? "(assign" + condition.substr(2)
               : condition;
  }

  std::string Each(const QuantifiedChange& each, const Rule& rule) const {
    const Rule scope = rule.WithVariable(each.variable);
    std::string where;
    for (const Literal& literal : each.where) {
      where += " " + Condition(literal, scope, -1);
    }
    return fmt::format("\n        (forall ({}) (when (and{}) {}))",
                       VariableOf(each.variable), where,
                       Change(each.change, scope));
  }

  std::string Effect(const Rule& rule) const {
    std::string text = "(probabilistic";
    for (const Outcome& outcome : rule.outcomes) {
      text += fmt::format("\n      {} (and", outcome.probability);
      for (const QuantifiedChange& each : outcome.each) {
        text += Each(each, rule);
      }
      for (const Literal& change : outcome.changes) {
        text += " " + Change(change, rule);
      }
      text += ")";
    }
    return rule.outcomes.empty() ? "(and)" : text + ")";
  }

  const NdrRules& rules_;
  const SymbolTable& symbols_;
  std::map<int, int> num_rules_;  // of each action, so far
};

}  // namespace

Result<std::string> ToPpddl(const NdrRules& rules, const std::string& name) {
  std::set<std::string> names;
  const auto& all = rules.symbols->all();
  for (size_t i = 0; i < all.size(); ++i) {
    if (!names.insert(Lower(NameOf(all[i].name))).second) {
      return Reason{fmt::format(
          "'{}' is also the name of another symbol, in PPDDL: case does not "
          "tell names apart there",
          all[i].name)};
    }
    const bool is_number = all[i].kind == Symbol::Kind::kCount ||
                           all[i].kind == Symbol::Kind::kSum;
    if (is_number && IsUsed(rules, static_cast<int>(i))) {
      return Reason{fmt::format(
          "a rule asks for '{}', a {}: PPDDL has no words for it", all[i].name,
          all[i].kind == Symbol::Kind::kSum ? "sum" : "count")};
    }
  }
  return PpddlText(rules).Domain(name);
}

}  // namespace cell::rules
