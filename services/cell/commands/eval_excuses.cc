#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <utility>

#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/evaluations/damaged_ppddl.h"
#include "services/cell/evaluations/damaged_rules.h"
#include "services/cell/evaluations/excuse_figures.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kAnotherCsv[] = "choose another --csv or remove it";
constexpr int kMaxStates = 1'000'000;
constexpr int kShownFailures = 5;

struct EvalExcusesOptions {
  std::string deploy_dir;
  std::string task_file;
  std::vector<std::string> ppddl_files;  // domain, problem
  int states = 500;
  uint64_t seed = 1;
  int jobs = 2;
  std::string rows_file;
  std::string csv_file;
  bool is_resumed = false;
};

std::filesystem::path FileOf(const EvalExcusesOptions& options) {
  if (!options.ppddl_files.empty()) return options.ppddl_files[1];
  if (!options.task_file.empty()) return options.task_file;
  return std::filesystem::path(
             FindCellFiles(options.deploy_dir).deployment.task_dir) /
         "learning/placements.rules";
}

/// Adds the files to the identity of the rows.
std::unique_ptr<DamagedDomain> LoadDomain(const EvalExcusesOptions& options,
                                          RowIdentity* identity) {
  const std::string path = FileOf(options).string();
  const std::string text = TextOfFile(path);
  if (options.ppddl_files.empty()) {
    identity->AddFile("the task file", text);
    return std::make_unique<DamagedRules>(rexd::ParseRexdTask(text, path));
  }
  const std::string& domain_path = options.ppddl_files[0];
  const std::string domain_text = TextOfFile(domain_path);
  identity->AddFile("the domain file", domain_text);
  identity->AddFile("the problem file", text);
  ppddl::Domain domain = ppddl::ParseDomain(domain_text, domain_path);
  ppddl::Problem problem = ppddl::ParseProblem(text, path, domain);
  return std::make_unique<DamagedPpddl>(std::move(domain), std::move(problem));
}

std::string RowsFile(const EvalExcusesOptions& options) {
  if (!options.rows_file.empty()) return options.rows_file;
  return fmt::format("runs/eval-excuses-{}-seed{}.jsonl",
                     FileOf(options).stem().string(), options.seed);
}

bool IsGood(const json& row) {
  return row.at("minimal") && row.at("holds") && row.at("named") &&
         row.at("helps");
}

void ShowFailures(const std::vector<json>& rows) {
  int num_shown = 0;
  for (const json& row : rows) {
    if (IsGood(row) || ++num_shown > kShownFailures) continue;
    std::cout << PrintableLines(fmt::format(
        "seed {}: {}: excuses {}; said: {}\n", row.at("seed").get<uint64_t>(),
        row.at("what").get<std::string>(), row.at("excuses").get<std::string>(),
        row.at("text").get<std::string>()));
  }
}

int EvalExcuses(const EvalExcusesOptions& options) {
  RequireDistinct({options.csv_file, options.rows_file});
  if (!options.csv_file.empty()) RequireFree(options.csv_file, kAnotherCsv);
  RowIdentity identity{"eval excuses", {}, {}};
  const auto domain = LoadDomain(options, &identity);
  std::vector<std::string> keys;
  for (int i = 0; i < options.states; ++i) {
    keys.push_back(std::to_string(options.seed + static_cast<uint64_t>(i)));
  }
  RowStore store({.path = RowsFile(options),
                  .is_resumed = options.is_resumed,
                  .identity = std::move(identity),
                  .shape = ExcuseRowShape()});
  DoMissingRuns(
      keys, options.jobs,
      [&](size_t i) { return ExcuseRow(*domain, options.seed + i); }, &store);
  const std::vector<json> rows = store.RowsOf(keys);
  const auto figures = SummariseExcuses(rows);
  std::cout << ExcuseText(figures);
  ShowFailures(rows);
  if (!options.csv_file.empty()) {
    WriteNewFile(options.csv_file, ExcuseCsv(figures), kAnotherCsv);
    std::cout << "written: " << options.csv_file << "\n";
  }
  std::cout << fmt::format("rows in {} ({} of {} states)\n",
                           store.path().string(), rows.size(), keys.size());
  return figures.back().num_good == options.states ? 0 : 1;
}

void AddOptions(CLI::App* command, EvalExcusesOptions* options) {
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  CLI::Option* task = command->add_option(
      "--task-file", options->task_file,
      "world, goal and true rules (default: learning/placements.rules of the "
      "task)");
  command
      ->add_option("--ppddl", options->ppddl_files,
                   "domain file and problem file instead")
      ->expected(2)
      ->excludes(task);
  command->add_option("--states", options->states, "states without a plan")
      ->check(NumberIn(1, kMaxStates))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "seed of the first state")
      ->check(NumberIn<uint64_t>(0, UINT64_MAX - kMaxStates))
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "number of processes at a time")
      ->check(NumberIn(1, 256))
      ->capture_default_str();
  command->add_option("--rows", options->rows_file,
                      "write one row per state here (default: runs/eval-...)");
  command->add_option("--csv", options->csv_file, "write the table here");
  command->add_flag("--resume", options->is_resumed,
                    "keep the rows of an earlier call and run what is missing");
}

}  // namespace

void AddEvalExcuses(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalExcusesOptions>();
  CLI::App* command = eval.add_subcommand(
      "excuses",
      "Take a rule or an effect away, or add a false precondition, and ask in "
      "states that are left without a plan: whether the excuses are minimal "
      "(by trying all smaller changes of up to three literals), one holds a "
      "predicate that is missing, the guidance names it, and each makes the "
      "planner succeed. Exit code 1 unless all of it is true of all states.\n"
      "Example: cell eval excuses --states 500 --csv excuses.csv");
  AddOptions(command, options.get());
  command->callback([=] {
    *action = [=] {
      return EvalExcuses(*options);
    };
  });
}

}  // namespace cell::cli
