#include "services/cell/commands/rules_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "common/node/number_option.h"

namespace cell::cli {

void AddLearnerOptions(CLI::App* command, rules::LearnerOptions* options) {
  command
      ->add_option("--alpha", options->alpha,
                   "weight of the complexity penalty, eq. (1)")
      ->check(NumberIn(0.0, 1e6))
      ->capture_default_str();
  command
      ->add_option("--p-min", options->p_min,
                   "probability of a change that only noise explains")
      ->check(NumberIn(1e-300, 1.0))
      ->capture_default_str();
  command
      ->add_option("--p-min-default", options->p_min_default,
                   "the same where no rule applies")
      ->check(NumberIn(1e-300, 1.0))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "order of the examples")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
}

std::map<std::string, std::string> OptionTexts(
    const rules::LearnerOptions& options) {
  return {{"--alpha", fmt::format("{}", options.alpha)},
          {"--p-min", fmt::format("{}", options.p_min)},
          {"--p-min-default", fmt::format("{}", options.p_min_default)}};
}

}  // namespace cell::cli
