#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "common/node/number_option.h"
#include "common/rules/learning/learner.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/row_files.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_options.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"
#include "services/cell/running/progress.h"

namespace cell::cli {
namespace {

using nlohmann::json;

struct EvalRulesOptions {
  std::string data;
  std::string symbols;
  int num_seeds = 21;
  int num_folds = 0;
  std::string rows_file;  // empty: none
  bool is_resumed = false;
  int jobs = 2;
  rules::LearnerOptions learner;
};

int LiteralsOf(const rules::NdrRules& rules) {
  int number = 0;
  for (const rules::Rule& rule : rules.rules) number += rule.num_literals();
  return number;
}

int NumFolds(const EvalRulesOptions& options, const rules::ExperienceSet& set) {
  const int size = static_cast<int>(set.experiences.size());
  return options.num_folds > 0 ? std::min(options.num_folds, size) : size;
}

rules::LearnerOptions WithSeed(const EvalRulesOptions& options, size_t i) {
  rules::LearnerOptions learner = options.learner;
  learner.seed += i;
  return learner;
}

json LearnWithSeed(const rules::ExperienceSet& set,
                   const rules::LearnerOptions& options, int num_folds) {
  const Progress watch;
  rules::Learner learner(set.world, options);
  for (const rules::Experience& e : set.experiences) learner.Add(e);
  learner.Learn();
  const double seconds = watch.ElapsedSeconds();
  const rules::NdrRules rules = learner.Rules();
  const double log_p = set.experiences.size() > 1 ? rules::HeldOutLogLikelihood(
                                                        set, options, num_folds)
                                                  : 0;
  return {{"seed", options.seed},        {"score", learner.Score()},
          {"rules", rules.rules.size()}, {"literals", LiteralsOf(rules)},
          {"seconds", seconds},          {"log_p", log_p}};
}

/// The key of a row is its seed.
RowIdentity IdentityOf(const EvalRulesOptions& options, int num_folds) {
  RowIdentity identity{"eval rules", OptionTexts(options.learner), {}};
  identity.options["--folds"] = std::to_string(num_folds);
  AddExperiences(FilesOfExperiences(options.data, options.symbols), &identity);
  return identity;
}

RowShape SeedRowShape() {
  using enum RowShape::Kind;
  return RowShape::Record({{"seed", kSeed},
                           {"score", kNumber},
                           {"rules", kWhole},
                           {"literals", kWhole},
                           {"seconds", kNumber},
                           {"log_p", kNumber}});
}

std::vector<json> SeedRowsOf(const EvalRulesOptions& options,
                             const rules::ExperienceSet& set) {
  const int num_folds = NumFolds(options, set);
  const auto run = [&](size_t i) {
    return LearnWithSeed(set, WithSeed(options, i), num_folds);
  };
  std::vector<json> rows;
  const auto num_seeds = static_cast<size_t>(options.num_seeds);
  if (options.rows_file.empty()) {
    Progress progress;
    for (size_t i = 0; i < num_seeds; ++i) {
      progress.Show(fmt::format("seed {} of {}", i + 1, num_seeds));
      rows.push_back(run(i));
    }
    return rows;
  }
  std::vector<std::string> keys;
  for (size_t i = 0; i < num_seeds; ++i) {
    keys.push_back(std::to_string(WithSeed(options, i).seed));
  }
  RowStore store({.path = options.rows_file,
                  .is_resumed = options.is_resumed,
                  .identity = IdentityOf(options, num_folds),
                  .shape = SeedRowShape()});
  DoMissingRuns(keys, options.jobs, run, &store);
  return store.RowsOf(keys);
}

int EvalRules(const EvalRulesOptions& options) {
  const rules::ExperienceSet set =
      LoadExperiences(options.data, options.symbols);
  const std::vector<json> rows = SeedRowsOf(options, set);
  std::vector<double> scores;
  double held_out = 0;
  std::cout << fmt::format("{:>6} {:>10} {:>6} {:>9} {:>9} {:>20}\n", "seed",
                           "score", "rules", "literals", "seconds",
                           "held-out log p");
  for (const json& row : rows) {
    const auto log_p = row.at("log_p").get<double>();
    scores.push_back(row.at("score"));
    held_out += log_p / static_cast<double>(rows.size());
    std::cout << fmt::format("{:>6} {:>10.3f} {:>6} {:>9} {:>9.3f} {:>20.3f}\n",
                             row.at("seed").get<uint64_t>(), scores.back(),
                             row.at("rules").get<int>(),
                             row.at("literals").get<int>(),
                             row.at("seconds").get<double>(), log_p);
  }
  if (scores.empty()) return 1;
  const auto [low, high] = std::ranges::minmax(scores);
  std::cout << fmt::format(
      "score {:.3f} to {:.3f}; held-out log p of an experience {:.3f} ({} "
      "folds; anything may happen with 0.01)\n",
      low, high, held_out, NumFolds(options, set));
  return rows.size() == static_cast<size_t>(options.num_seeds) ? 0 : 1;
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
  CLI::Option* rows = command->add_option(
      "--rows", options->rows_file,
      "write a row for each seed here as it is done, so that an interrupted "
      "evaluation can go on");
  command
      ->add_flag("--resume", options->is_resumed,
                 "keep the rows of an earlier call with the same experiences, "
                 "and learn with the seeds that are missing")
      ->needs(rows);
  command
      ->add_option("--jobs", options->jobs,
                   "number of processes at a time, with --rows")
      ->check(NumberIn(1, 256))
      ->capture_default_str();
  AddLearnerOptions(command, &options->learner);
  command->callback([=] {
    *action = [=] {
      return EvalRules(*options);
    };
  });
}

}  // namespace cell::cli
