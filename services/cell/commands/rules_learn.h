#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "common/rules/rule.h"
#include "services/cell/commands/commands.h"

namespace cell::cli {

/// `cell rules learn`.
void AddRulesLearn(CLI::App& rules, Action* action);

/// All rules as people read them, probabilities with two digits.
std::string RulesToShow(const rules::NdrRules& rules);

}  // namespace cell::cli
