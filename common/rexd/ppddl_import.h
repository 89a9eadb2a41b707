#pragma once

#include <string>

namespace cell::rexd {

/// A PPDDL text and where it comes from, for errors.
struct PpddlText {
  std::string text;
  std::string file;
};

/// A PPDDL domain as noisy deictic rules, one for each action, in the text that
/// rules::ParseRules() reads. Types become predicates, and the conditions of
/// actions; what no outcome says is the outcome in which nothing changes; costs
/// and rewards are left out. A parameter of which a precondition says that it
/// is the only object for which some literals hold, as rules::ToPpddl() writes
/// references, becomes a reference.
/// @throws ppddl::PpddlError with line and column for what rules have no words
/// for: conditional and quantified effects, disjunctions, more than
/// rules::kMaxArity arguments, names that have another meaning there
std::string RulesOfPpddl(const PpddlText& domain);

/// The same of a problem of the domain, in the text that ParseRexdTask() reads.
/// Its goal must be a conjunction of literals.
std::string TaskOfPpddl(const PpddlText& domain, const PpddlText& problem);

}  // namespace cell::rexd
