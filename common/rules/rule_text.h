#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/rules/rule.h"

namespace cell::rules {

/// How a literal of the rule reads: "not on(X, _)", "size(X) >= 3", "X != Y".
std::string ToText(const Literal& literal, const Rule& rule,
                   const SymbolTable& symbols);

/// A rule as in Fig. 10 of the paper:
///
///   Action: grab(X)
///   References: Y: on(X, Y); Z: table(Z), not on(_, Z)
///   Preconditions: block(X), height(X) <= 3
///   Effects:
///     0.75: inhand(X), not on(X, Y)
///       each P: not clear(P) if on(P, X), not heavy(P)
///     0.05: nothing
///     0.2: noise
///
/// @param num_digits  of probabilities; 0: as many as they need to be read back
///                    exactly
std::string ToText(const Rule& rule, const SymbolTable& symbols,
                   int num_digits = 0);

/// The symbols, then all rules: what ParseRules() reads back as it was.
std::string ToText(const NdrRules& rules);

/// Reads declarations of symbols (SymbolTable::Parse()) and rules.
/// @throws RuleError "file:line: ..." for unknown symbols, variables and
/// constants, wrong numbers of arguments, changes of derived predicates, and
/// probabilities that do not sum to 1
NdrRules ParseRules(const std::string& text, const std::string& file);

/// A rule and the line of its file where it begins.
struct PlacedRule {
  int line = 0;
  Rule rule;
};
/// Reads the rules of such a text in the words of other symbols than the text
/// declares: those of a task that may have changed since. @throws like
/// ParseRules()
std::vector<PlacedRule> ParseRulesOf(std::shared_ptr<const SymbolTable> symbols,
                                     const std::string& text,
                                     const std::string& file);

}  // namespace cell::rules
