#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>

#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/text/nearest.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/eval_sec.h"
#include "services/cell/commands/eval_shown.h"
#include "services/cell/commands/row_files.h"
#include "services/cell/evaluations/evaluation.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr int kMaxRuns = 1'000'000;
constexpr char kAnotherJson[] = "choose another --json or remove it";

struct EvalOptions {
  std::shared_ptr<Evaluation> evaluation;
  std::string deploy_dir;
  int runs = 0;
  std::string group;  // empty: all
  uint64_t seed = 1;
  int jobs = 2;
  std::string json_file;
  std::string rows_file;
  bool is_resumed = false;
  std::string sensing;
};

std::string KeyOf(const Trial& trial) {
  return fmt::format("{}/{}", trial.group, trial.seed);
}

/// The files to run by. What is asked for must be what they say.
CellFiles FilesFor(const EvalOptions& options) {
  CellFiles files = FindCellFiles(options.deploy_dir);
  const Config tracker = files.deployment.ForService("tracker");
  const auto sensing = tracker.Get<std::string>("sensing");
  if (!options.sensing.empty() && options.sensing != sensing) {
    tracker["sensing"].Fail(
        fmt::format("is {}, but {} is asked for", sensing, options.sensing));
  }
  CheckTask(files);
  return files;
}

/// The key of a row says which group and seed it is of.
RowIdentity IdentityOf(const EvalOptions& options, const CellFiles& files) {
  RowIdentity identity{"eval " + options.evaluation->name(), {}, {}};
  AddDeployment(files.deployment, &identity);
  return identity;
}

RowShape ShapeOf(const Evaluation& evaluation) {
  return evaluation.row_shape().With({{"group", RowShape::kText}});
}

json RunTrial(const EvalOptions& options, const CellFiles& files,
              const Trial& trial) {
  json row =
      options.evaluation->RunTrial(trial, files.deployment, files.roster);
  row["group"] = trial.group;
  row["seed"] = trial.seed;
  return row;
}

/// Without those of other groups than the one that is asked for.
template <class Named>
std::vector<Named> OfGroup(const EvalOptions& options, std::vector<Named> all) {
  std::erase_if(all, [&](const Named& one) {
    return !options.group.empty() &&
           !one.name.starts_with(options.group + ": ");
  });
  return all;
}

std::vector<Measure> MeasuresOf(const EvalOptions& options,
                                const std::vector<json>& rows) {
  return OfGroup(options, options.evaluation->Measures(rows));
}

std::vector<Figure> FiguresOf(const EvalOptions& options,
                              const std::vector<json>& rows) {
  return OfGroup(options, options.evaluation->Figures(rows));
}

json ToJson(const Measure& measure, uint64_t seed) {
  const Interval interval = measure.interval();
  return {{"measure", measure.name},
          {"value", measure.value()},
          {"low", interval.low},
          {"high", interval.high},
          {"paper", measure.paper ? json(*measure.paper) : json()},
          {"goal", measure.goal},
          {"met", measure.is_met()},
          {"runs", measure.num_all},
          {"seed", seed}};
}

json ToJson(const Figure& figure, uint64_t seed) {
  return {{"figure", figure.name},
          {"value", figure.value},
          {"unit", figure.unit},
          {"seed", seed}};
}

void Print(const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) {
    std::cout << fmt::format("{:66} {:17.1f} {}\n", figure.name, figure.value,
                             figure.unit);
  }
}

void Print(const std::vector<Measure>& measures) {
  std::cout << fmt::format("{:66} {:>9} {:>7}  {:15} {:>6} {:>5}\n", "measure",
                           "of", "value", "95 % interval", "paper", "goal");
  for (const Measure& m : measures) {
    const Interval interval = m.interval();
    std::cout << fmt::format(
        "{:66} {:>9} {:6.1f} %  {:5.1f} - {:5.1f} % {:>6} {:>3.0f} % {}\n",
        m.name, fmt::format("{}/{}", m.num_good, m.num_all), 100 * m.value(),
        100 * interval.low, 100 * interval.high,
        m.paper ? fmt::format("{:.0f} %", 100 * *m.paper) : "-", 100 * m.goal,
        m.verdict());
  }
}

json ToJson(const std::vector<Measure>& measures,
            const std::vector<Figure>& figures, uint64_t seed) {
  json report = json::array();
  for (const Measure& m : measures) report.push_back(ToJson(m, seed));
  for (const Figure& f : figures) report.push_back(ToJson(f, seed));
  return report;
}

// What a report is about: the names in it, each with its seed.
std::set<std::string> TopicsOf(const json& report) {
  std::set<std::string> topics;
  if (!report.is_array()) return topics;
  for (const json& entry : report) {
    if (!entry.is_object()) return {};
    topics.insert(entry.value("measure", json()).dump() +
                  entry.value("figure", json()).dump() +
                  entry.value("seed", json()).dump());
  }
  return topics;
}

// Checks, before hours of work, that the measures can be written at their end.
// A resumed evaluation may replace its measures of fewer rows.
void RequireFreeJson(const EvalOptions& options) {
  if (options.json_file.empty()) return;
  if (options.is_resumed) {
    std::ifstream file(options.json_file);
    const json old = json::parse(file, nullptr, false);
    const json mine =
        ToJson(MeasuresOf(options, {}), FiguresOf(options, {}), options.seed);
    if (TopicsOf(old) == TopicsOf(mine)) return;
  }
  RequireFree(options.json_file, kAnotherJson);
}

void WriteJson(const EvalOptions& options, const json& report) {
  if (options.json_file.empty()) return;
  const std::string text = report.dump(2) + "\n";
  options.is_resumed ? WriteFile(options.json_file, text)
                     : WriteNewFile(options.json_file, text, kAnotherJson);
}

int RunEval(const EvalOptions& options) {
  const CellFiles files = FilesFor(options);
  RequireDistinct({options.json_file, options.rows_file});
  RequireFreeJson(options);
  const int runs =
      options.runs > 0 ? options.runs : options.evaluation->default_runs();
  const auto trials =
      options.evaluation->Trials(runs, options.seed, options.group);
  const std::string path = options.rows_file.empty()
                               ? fmt::format("runs/eval-{}{}{}-seed{}.jsonl",
                                             options.evaluation->name(),
                                             options.group.empty() ? "" : "-",
                                             options.group, options.seed)
                               : options.rows_file;
  RowStore store({.path = path,
                  .is_resumed = options.is_resumed,
                  .identity = IdentityOf(options, files),
                  .shape = ShapeOf(*options.evaluation)});
  std::vector<std::string> keys;
  for (const Trial& trial : trials) keys.push_back(KeyOf(trial));
  DoMissingRuns(
      keys, options.jobs,
      [&](size_t i) { return RunTrial(options, files, trials[i]); }, &store);

  const std::vector<json> rows = store.RowsOf(keys);
  const auto measures = MeasuresOf(options, rows);
  const auto figures = FiguresOf(options, rows);
  Print(measures);
  Print(figures);
  bool is_met = rows.size() == trials.size();
  for (const Measure& measure : measures) is_met &= measure.is_met();
  WriteJson(options, ToJson(measures, figures, options.seed));
  std::cout << fmt::format("rows in {} ({} of {} runs)\n",
                           store.path().string(), rows.size(), trials.size());
  return is_met ? 0 : 1;
}

}  // namespace

void AddEval(CLI::App& app, Action* action) {
  CLI::App* eval = app.add_subcommand(
      "eval",
      "Measure the cell's performance against its goals, with confidence "
      "intervals.\n"
      "Example: cell eval watch --runs 50 --seed 1 --jobs 2 --json watch.json");
  eval->require_subcommand(1);
  for (auto& evaluation : AllEvaluations()) {
    auto options = std::make_shared<EvalOptions>();
    options->evaluation = std::move(evaluation);
    CLI::App* command = eval->add_subcommand(
        options->evaluation->name(),
        options->evaluation->description() + "\nExample: cell eval " +
            options->evaluation->name() + " --runs 10 --seed 1");
    command->add_option("--deploy", options->deploy_dir,
                        "folder with config/ and tasks/");
    command
        ->add_option(
            "--runs", options->runs,
            "runs of the largest group (default: what the goal requires)")
        ->check(NumberIn(1, kMaxRuns));
    if (const auto groups = options->evaluation->groups(); groups.size() > 1) {
      command
          ->add_option("--group", options->group,
                       "only the runs of this group, --runs of them")
          ->check(CLI::IsMember(NamesIn(groups, &TrialGroup::name)));
    }
    command->add_option("--seed", options->seed, "seed of the first run")
        ->check(NumberIn<uint64_t>(0, UINT64_MAX - kMaxRuns))
        ->capture_default_str();
    command
        ->add_option("--jobs", options->jobs, "number of processes at a time")
        ->check(NumberIn(1, 256))
        ->capture_default_str();
    command->add_option("--json", options->json_file,
                        "write the measures here");
    command->add_option("--rows", options->rows_file,
                        "write one row per run here (default: runs/eval-...)");
    command->add_flag(
        "--resume", options->is_resumed,
        "keep the rows of an earlier call and run what is missing");
    command->add_option("--sensing", options->sensing,
                        "must agree with tracker.yaml (default: its value)");
    command->callback([=] {
      *action = [=] {
        return RunEval(*options);
      };
    });
  }
  AddEvalSec(*eval, action);
  AddEvalShown(*eval, action);
  AddEvalRules(*eval, action);
  AddEvalRexd(*eval, action);
  AddEvalGrowth(*eval, action);
  AddEvalExcuses(*eval, action);
  AddEvalMistakes(*eval, action);
}

}  // namespace cell::cli
