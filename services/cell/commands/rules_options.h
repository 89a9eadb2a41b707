#pragma once

#include "common/rules/learning/options.h"

namespace CLI {
class App;
}

namespace cell::cli {

/// Adds --alpha, --p-min, --p-min-default and --seed.
void AddLearnerOptions(CLI::App* command, rules::LearnerOptions* options);

}  // namespace cell::cli
