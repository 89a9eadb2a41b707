#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/library_members.h"
#include "common/sec/role_similarity.h"
#include "common/sec/sec_learner.h"
#include "common/task/task.h"
#include "services/cell/commands/library_models.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/running/task_variant.h"

namespace cell::cli {
namespace {

struct SimilarOptions {
  std::string database;
  std::string deploy_dir;
  std::string variant;
  double threshold = SecLearner::Params{}.threshold;
};

/// "name  1.00  0.30 ...", the columns in the order of the rows; and what is
/// alike.
void PrintMatrix(const std::string& title, std::span<const std::string> names,
                 const std::vector<std::vector<double>>& similarities,
                 double threshold) {
  std::cout << title << ":\n";
  for (size_t i = 0; i < names.size(); ++i) {
    std::cout << fmt::format("  {:>2} {:20}", i + 1, names[i]);
    for (const double similarity : similarities[i]) {
      std::cout << fmt::format(" {:5.2f}", similarity);
    }
    std::cout << "\n";
  }
  for (const auto& group : GroupsOf(similarities, threshold)) {
    if (group.size() < 2) continue;
    std::vector<std::string> members;
    for (const size_t i : group) members.push_back(names[i]);
    std::cout << fmt::format("  alike: {}\n", fmt::join(members, ", "));
  }
}

/// The distribution of the similarities that divides what is one action.
void PrintHistogram(const MemberHistogram& histogram,
                    std::span<const std::string> models) {
  if (histogram.num_pairs() == 0) return;
  std::cout << fmt::format(
      "{} pairs of what was shown, of one action and of two, by similarity:\n",
      histogram.num_pairs());
  for (size_t bin = 0; bin < histogram.kNumBins; ++bin) {
    if (histogram.of_one[bin] + histogram.of_two[bin] == 0) continue;
    const double low = static_cast<double>(bin) / histogram.kNumBins;
    std::cout << fmt::format("  {:.2f} to {:.2f} {:6} {:6}\n", low,
                             low + 1.0 / histogram.kNumBins,
                             histogram.of_one[bin], histogram.of_two[bin]);
  }
  std::cout << fmt::format(
      "  Otsu's bound {:.2f}; tau, the mean from there on, {:.2f}; the cell "
      "takes showings for one action from {:.2f} on, if their types agree\n",
      histogram.cut, histogram.tau, SecLearner::Params{}.threshold);
  for (const auto& [a, b] : histogram.alike) {
    std::cout << fmt::format("  types alone tell {} and {} apart\n", models[a],
                             models[b]);
  }
}

int Similar(const SimilarOptions& options) {
  Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  std::optional<VariedTask> varied;
  if (!options.variant.empty()) {
    deployment = varied.emplace(deployment, options.variant).deployment();
  }
  const Task task = LoadTask(deployment);
  const SceneWords words{task.domain.vocabulary(), task.parts};
  const auto models = ModelsOf(options.database, task);
  if (models.empty()) {
    throw std::runtime_error("no action has been learned; cell learn sec");
  }
  const auto chains = MakeChainSimilarity(SecLearner::kMeasure);
  const RoleSimilarity roles(models, words, *chains);
  std::vector<std::string> names;
  for (const auto& [name, model] : models) names.push_back(name);
  PrintMatrix("actions", names, roles.OfActions(), options.threshold);
  PrintHistogram(HistogramOf(CompareMembers(models, words, *chains)), names);
  PrintMatrix("objects, by the roles that they play", roles.Types(),
              roles.OfTypes(), options.threshold);
  for (const auto& [object, action] : roles.AllStandIns()) {
    std::cout << fmt::format(
        "{} was never shown, but can stand in for the moved part of {}\n",
        object, action);
  }
  return 0;
}

}  // namespace

void AddSecSimilar(CLI::App& sec, Action* action) {
  auto options = std::make_shared<SimilarOptions>();
  CLI::App* command = sec.add_subcommand(
      "similar",
      "Show what can stand in for what: how alike the actions are that were "
      "learned, with the histogram of what taught them and Otsu's bound, and "
      "the objects by the roles that they play in them.\n"
      "Example: cell sec similar --database runs/demo-0001");
  command->add_option("--database", options->database,
                      "a library's file, or a run folder that has one "
                      "(default: the models that the task comes with)");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--variant", options->variant,
                      "change the task as its variants/NAME.yaml says");
  command
      ->add_option("--threshold", options->threshold,
                   "the least similarity of what is alike")
      ->check(NumberIn(0.0, 1.0))
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return Similar(*options);
    };
  });
}

}  // namespace cell::cli
