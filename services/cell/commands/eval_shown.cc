#include "services/cell/commands/eval_shown.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "common/actions/sec_models.h"
#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/recordings/recording_file.h"
#include "common/task/task.h"
#include "services/cell/evaluations/demonstration_set.h"
#include "services/cell/evaluations/goal_table.h"
#include "services/cell/evaluations/layer_ablation.h"
#include "services/cell/evaluations/shown_groups.h"
#include "services/cell/evaluations/shown_stream.h"
#include "services/cell/evaluations/stream_score.h"
#include "services/cell/running/progress.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

/// With two hands and one, reversals, unknown moves.
const std::vector<std::string> kStreamScripts = {
    "assembly_two_hands", "take_backs", "take_backs_and_unknown_moves",
    "unknown_moves"};

/// Nothing but placements.
const std::vector<std::string> kGroupScripts = {"assembly",
                                                "assembly_two_hands"};

constexpr int kGroupOrders = 20;
constexpr char kChooseAnotherCsv[] = "choose another --csv";

struct EvalShownOptions {
  std::string deploy_dir;
  int runs = 0;
  double noise_mm = 2;
  uint64_t seed = 1;
  int jobs = 2;
  std::string recordings = "runs/demonstrations";
  std::string csv;
};

/// What is shown, and how: without a library.
class ShownInput {
 public:
  ShownInput(const EvalShownOptions& options,
             const std::vector<std::string>& scripts)
      : files_(CheckedFiles(options)), task_(LoadTask(files_.deployment)) {
    for (const auto& path :
         MakeDemonstrations({options.recordings, scripts, options.runs,
                             options.seed, options.jobs},
                            files_)) {
      params.demonstrations.push_back({path.stem().string(), [path] {
                                         return LoadRecording(path);
                                       }});
    }
    params.noise_mm = options.noise_mm;
    params.seed = options.seed;
  }

  const Deployment& deployment() const { return files_.deployment; }
  const Task& task() const { return task_; }
  std::map<std::string, std::string> Placements() const {
    return PlacementNames(
        vtb::Demonstrations::FromConfig(
            deployment().OfTask("demonstrators.yaml"), task_.parts),
        task_.parts);
  }

  ShownStreamParams params;

 private:
  static CellFiles CheckedFiles(const EvalShownOptions& options) {
    CellFiles files = FindCellFiles(options.deploy_dir);
    CheckTask(files);
    return files;
  }

  CellFiles files_;
  Task task_;
};

void PrintConfidence(const char* what, std::vector<double> confidences) {
  if (confidences.empty()) return;
  std::ranges::sort(confidences);
  const double sum =
      std::accumulate(confidences.begin(), confidences.end(), 0.0);
  std::cout << fmt::format(
      "confidence of {:24} mean {:.2f}, least {:.2f}, 5th percentile {:.2f}\n",
      what, sum / static_cast<double>(confidences.size()), confidences.front(),
      confidences[confidences.size() / 20]);
}

int RunStream(const EvalShownOptions& options) {
  ShownInput input(options, kStreamScripts);
  const Task& task = input.task();
  input.params.library =
      MakeSecLibrary({task.domain, task.parts, task.actions});
  Progress progress;
  const ShownStream stream =
      ShowStream(input.params, input.deployment(), task,
                 [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  const StreamScore score = Score(stream, input.Placements());
  for (const std::string& error : score.errors) std::cout << error << '\n';
  std::cout << fmt::format(
      "one stream of {} demonstrations, pose noise {:g} mm, seed {}\n",
      options.runs, options.noise_mm, options.seed);
  const auto measures = StreamMeasures(score);
  std::cout << GoalTable(measures);
  PrintConfidence("what is right:", score.confidence_right);
  PrintConfidence("what is wrong:", score.confidence_wrong);
  return AreMet(measures) ? 0 : 1;
}

int RunGroups(const EvalShownOptions& options) {
  const ShownInput input(options, kGroupScripts);
  const Task& task = input.task();
  Progress progress;
  const auto chains =
      ShowChains(input.params, input.deployment(), task, input.Placements(),
                 [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  std::vector<ShownGroups> results;
  for (const ShownGrouping& grouping : ShownGroupings()) {
    for (int order = 0; order < kGroupOrders; ++order) {
      results.push_back(GroupChains(
          chains, task, grouping, options.seed + static_cast<uint64_t>(order)));
      if (order == 0) std::cout << ToText(results.back());
    }
  }
  std::cout << fmt::format(
                   "{} placements of {} demonstrations in {} random orders, "
                   "pose noise {:g} mm, seed {}\n",
                   chains.size(), options.runs, kGroupOrders, options.noise_mm,
                   options.seed)
            << ShownGroupsTable(results);
  const auto measures = ShownGroupsMeasures(results);
  std::cout << GoalTable(measures);
  return AreMet(measures) ? 0 : 1;
}

int RunLayers(const EvalShownOptions& options) {
  ShownInput input(options, kGroupScripts);
  input.params.has_layers = true;
  if (!options.csv.empty()) RequireFree(options.csv, kChooseAnotherCsv);
  const Task& task = input.task();
  Progress progress;
  const auto chains =
      ShowChains(input.params, input.deployment(), task, input.Placements(),
                 [&](const std::string& text) { progress.Show(text); });
  progress.Show("comparing placements");
  const auto results = AblateLayers(chains, task, options.seed);
  progress.Clear();
  std::cout << fmt::format(
                   "{} placements of {} demonstrations, pose noise {:g} mm, "
                   "seed {}\n",
                   chains.size(), options.runs, options.noise_mm, options.seed)
            << LayersTable(results);
  if (options.csv.empty()) return 0;
  WriteNewFile(options.csv,
               LayersToCsv(results, options.seed, options.noise_mm),
               kChooseAnotherCsv);
  return 0;
}

CLI::App* AddShown(CLI::App& eval, const std::string& name,
                   const std::string& description, int default_runs,
                   std::shared_ptr<EvalShownOptions> options) {
  options->runs = default_runs;
  CLI::App* command = eval.add_subcommand(name, description);
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--runs", options->runs, "demonstrations")
      ->check(NumberIn(1, 100'000))
      ->capture_default_str();
  command
      ->add_option("--noise-mm", options->noise_mm,
                   "standard deviation of each coordinate of a pose")
      ->check(NumberIn(0.0, 100.0))
      ->capture_default_str();
  command
      ->add_option("--seed", options->seed,
                   "of the first demonstration, and of the noise")
      ->check(NumberIn<uint64_t>(0, UINT32_MAX))
      ->capture_default_str();
  command
      ->add_option("--jobs", options->jobs,
                   "processes at a time that simulate demonstrations")
      ->check(NumberIn(1, 256))
      ->capture_default_str();
  command
      ->add_option("--recordings", options->recordings,
                   "folder of simulated demonstrations; those that it lacks "
                   "are made")
      ->capture_default_str();
  return command;
}

}  // namespace

void AddEvalShown(CLI::App& eval, Action* action) {
  auto stream = std::make_shared<EvalShownOptions>();
  AddShown(eval, "stream",
           "Recognise the actions in demonstrations that are shown as one "
           "unsegmented stream: with two hands, reversals, unknown moves and "
           "pauses, from noisy poses.\n"
           "Example: cell eval stream --runs 40 --noise-mm 2",
           200, stream)
      ->callback([=] {
        *action = [=] {
          return RunStream(*stream);
        };
      });
  auto groups = std::make_shared<EvalShownOptions>();
  AddShown(eval, "groups",
           "Group the actions of demonstrations without labels by the "
           "similarity of their event chains, and their objects by role.\n"
           "Example: cell eval groups --runs 20 --noise-mm 2",
           40, groups)
      ->callback([=] {
        *action = [=] {
          return RunGroups(*groups);
        };
      });
  auto layers = std::make_shared<EvalShownOptions>();
  CLI::App* command = AddShown(
      eval, "layers",
      "Measure how much static and dynamic relations of key frames (inside, "
      "on, above, below; getting closer, moving apart, moving together) help "
      "to tell the actions of demonstrations apart.\n"
      "Example: cell eval layers --runs 20 --csv layers.csv",
      40, layers);
  command->add_option("--csv", layers->csv, "also write the figures here");
  command->callback([=] {
    *action = [=] {
      return RunLayers(*layers);
    };
  });
}

}  // namespace cell::cli
