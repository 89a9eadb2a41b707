#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "common/node/number_option.h"
#include "common/rules/learning/learner.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_options.h"
#include "services/cell/running/progress.h"

namespace cell::cli {
namespace {

struct EvalRulesOptions {
  std::string data;
  std::string symbols;
  int num_seeds = 21;
  int num_folds = 0;
  rules::LearnerOptions learner;
};

int LiteralsOf(const rules::NdrRules& rules) {
  int number = 0;
  for (const rules::Rule& rule : rules.rules) number += rule.num_literals();
  return number;
}

int EvalRules(const EvalRulesOptions& options) {
  const rules::ExperienceSet set =
      LoadExperiences(options.data, options.symbols);
  const int size = static_cast<int>(set.experiences.size());
  const int num_folds =
      options.num_folds > 0 ? std::min(options.num_folds, size) : size;
  Progress progress;
  std::vector<double> scores;
  double held_out = 0;
  std::cout << fmt::format("{:>6} {:>10} {:>6} {:>9} {:>9} {:>20}\n", "seed",
                           "score", "rules", "literals", "seconds",
                           "held-out log p");
  for (int i = 0; i < options.num_seeds; ++i) {
    progress.Show(fmt::format("seed {} of {}", i + 1, options.num_seeds));
    rules::LearnerOptions learner_options = options.learner;
    learner_options.seed += static_cast<uint64_t>(i);
    const double start = progress.ElapsedSeconds();
    rules::Learner learner(set.world, learner_options);
    for (const rules::Experience& e : set.experiences) learner.Add(e);
    learner.Learn();
    const double seconds = progress.ElapsedSeconds() - start;
    const double log_p =
        size > 1 ? rules::HeldOutLogLikelihood(set, learner_options, num_folds)
                 : 0;
    const rules::NdrRules rules = learner.Rules();
    progress.Clear();
    std::cout << fmt::format("{:>6} {:>10.3f} {:>6} {:>9} {:>9.3f} {:>20.3f}\n",
                             learner_options.seed, learner.Score(),
                             rules.rules.size(), LiteralsOf(rules), seconds,
                             log_p);
    scores.push_back(learner.Score());
    held_out += log_p / options.num_seeds;
  }
  const auto [low, high] = std::ranges::minmax(scores);
  std::cout << fmt::format(
      "score {:.3f} to {:.3f}; held-out log p of an experience {:.3f} ({} "
      "folds; anything may happen with 0.01)\n",
      low, high, held_out, num_folds);
  return 0;
}

}  // namespace

void AddEvalRules(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalRulesOptions>();
  CLI::App* command = eval.add_subcommand(
      "rules",
      "Learn rules from experiences with several seeds: the score, eq. (1), "
      "and "
      "the log likelihood of experiences that were held out.\n"
      "Example: cell eval rules experiences --seeds 21");
  command->add_option("data", options->data, "folder, or file of experiences")
      ->required();
  command->add_option("--symbols", options->symbols,
                      "file of symbols (default: symbols.dat beside the data)");
  command->add_option("--seeds", options->num_seeds, "number of seeds")
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  command
      ->add_option("--folds", options->num_folds,
                   "parts that are held out in turn (default: one for each "
                   "experience)")
      ->check(NumberIn(2, 1'000'000));
  AddLearnerOptions(command, &options->learner);
  command->callback([=] {
    *action = [=] {
      return EvalRules(*options);
    };
  });
}

}  // namespace cell::cli
