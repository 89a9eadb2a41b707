#pragma once

#include <string>

#include "common/rules/experience.h"

namespace cell::rules {

/// Reads one state: "on(a b) size(a)=3 handempty()". Derived atoms are checked
/// for being declared, and then set by their definitions.
/// @throws RuleError "file:line: ..."
WorldState ParseState(const std::string& text, const std::string& file,
                      int line, const World& world);

/// Reads experiences: a line with a state, one with an action, one with the
/// state after it, which is also the one before the next action. A state after
/// a state begins another sequence. '#' begins a comment. Objects are numbered
/// as they appear.
///
///   on(a b) table(b) size(a)=3
///   grab(a)
///   inhand(a) table(b) size(a)=3
///
/// @throws RuleError "file:line: ..." for unknown symbols, wrong numbers of
/// arguments, values of predicates, missing states, and functions with two
/// values.
ExperienceSet ParseExperiences(const std::string& text, const std::string& file,
                               std::shared_ptr<const SymbolTable> symbols);

/// The state as ParseState() reads it, without derived atoms.
std::string ToText(const WorldState& state, const World& world);
/// As ParseExperiences() reads them; equal states that follow each other are
/// written once.
std::string ToText(const ExperienceSet& set);

}  // namespace cell::rules
