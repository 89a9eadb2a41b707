#pragma once

#include <map>
#include <string>

#include "common/rules/learning/options.h"

namespace CLI {
class App;
}

namespace cell::cli {

/// Adds --alpha, --p-min, --p-min-default and --seed.
void AddLearnerOptions(CLI::App* command, rules::LearnerOptions* options);

/// What these options are, but --seed, by their names.
std::map<std::string, std::string> OptionTexts(
    const rules::LearnerOptions& options);

}  // namespace cell::cli
