#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/rexd/rexd_run.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kAnotherTable[] = "choose another --csv or remove it";
constexpr const char* kCounts[] = {"actions", "demonstrations", "explorations"};

struct EvalRexdOptions {
  std::string deploy_dir;
  std::string task_file;
  std::vector<double> successes = {1, 0.8, 0.6, 0.4};
  std::string teacher = "sure";
  bool is_guided = true;
  bool explores_no_ops = true;
  int runs = 100;
  int episodes = 4;
  uint64_t seed = 1;
  int jobs = 2;
  std::string rows_file;
  std::string csv_file;
  bool is_resumed = false;
};

struct RexdTrial {
  double success;
  uint64_t seed;
  std::string Key() const { return fmt::format("{}/{}", success, seed); }
};

rexd::RexdTask LoadRexdTask(const EvalRexdOptions& options) {
  const std::filesystem::path path =
      options.task_file.empty()
          ? std::filesystem::path(
                FindCellFiles(options.deploy_dir).deployment.task_dir) /
                "learning/placements.rules"
          : std::filesystem::path(options.task_file);
  return rexd::ParseRexdTask(TextOfFile(path), path.string());
}

json RunTrial(const rexd::RexdTask& task, const EvalRexdOptions& options,
              const RexdTrial& trial) {
  rexd::RunParams params;
  params.success = trial.success;
  params.seed = trial.seed;
  params.num_episodes = options.episodes;
  params.teacher.is_sure = options.teacher == "sure";
  params.teacher.heeds_guidance = options.is_guided;
  params.learner.explores_no_ops = options.explores_no_ops;
  json row = {{"success", trial.success}, {"seed", trial.seed}};
  for (const rexd::EpisodeCounts& counts : rexd::RunRexd(task, params)) {
    row["actions"].push_back(counts.num_actions);
    row["demonstrations"].push_back(counts.num_demonstrations);
    row["explorations"].push_back(counts.num_explorations);
    row["reached"].push_back(counts.is_goal_reached ? 1 : 0);
  }
  return row;
}

struct MeanAndSd {
  double mean = 0;
  double sd = 0;
};

MeanAndSd Summarise(const std::vector<double>& values) {
  MeanAndSd summary;
  const double n = static_cast<double>(values.size());
  for (const double value : values) summary.mean += value / n;
  for (const double value : values) {
    summary.sd += (value - summary.mean) * (value - summary.mean);
  }
  summary.sd = n > 1 ? std::sqrt(summary.sd / (n - 1)) : 0;
  return summary;
}

/// A count of each row, summed over its episodes from `first` to `last`.
std::vector<double> ValuesOf(const std::vector<json>& rows, const char* count,
                             int first, int last) {
  std::vector<double> values;
  for (const json& row : rows) {
    double sum = 0;
    for (int i = first; i <= last; ++i) {
      sum += row.at(count).at(static_cast<size_t>(i)).get<double>();
    }
    values.push_back(sum);
  }
  return values;
}

/// Prints the figures of one success rate; returns its lines of the table.
std::string Report(const EvalRexdOptions& options, double success,
                   const std::vector<json>& rows) {
  std::string csv;
  std::cout << fmt::format("success {}, {} runs, teacher {}\n", success,
                           rows.size(), options.teacher);
  for (int i = 0; i <= options.episodes; ++i) {
    const bool is_total = i == options.episodes;
    const int first = is_total ? 0 : i;
    const int last = is_total ? options.episodes - 1 : i;
    const std::string name = is_total ? "all" : std::to_string(i + 1);
    std::string line = fmt::format("  episode {:>3}:", name);
    csv += fmt::format("{},{}", success, name);
    for (const char* count : kCounts) {
      const MeanAndSd s = Summarise(ValuesOf(rows, count, first, last));
      line += fmt::format("  {} {:.1f} (sd {:.1f})", count, s.mean, s.sd);
      csv += fmt::format(",{},{}", s.mean, s.sd);
    }
    const MeanAndSd reached = Summarise(ValuesOf(rows, "reached", first, last));
    const double share = reached.mean / (is_total ? options.episodes : 1);
    std::cout << fmt::format("{}  goal reached {:.1f} %\n", line, 100 * share);
    csv += fmt::format(",{}\n", share);
  }
  return csv;
}

/// Commands of gnuplot that draw the table as Fig. 17.
std::string PlotOf(const EvalRexdOptions& options) {
  std::string text = fmt::format(
      "# gnuplot {0}.gp makes {0}.png\n"
      "set terminal pngcairo size 900,1100\nset output '{0}.png'\n"
      "set datafile sep ','\nset multiplot layout 3,1\n"
      "set xrange [0.5:{1}.5]\nset xtics 1\nset key outside\n"
      "set xlabel 'episode'\n",
      options.csv_file, options.episodes);
  int column = 3;
  for (const char* count : kCounts) {
    text += fmt::format("set ylabel '{}'\nplot ", count);
    for (size_t i = 0; i < options.successes.size(); ++i) {
      const double success = options.successes[i];
      text += fmt::format(
          "{}'{}' using (abs($1-{})<1e-9 && $2>0 ? $2+{:.2f} : NaN):{}:{} "
          "with yerrorbars title 'success {}'",
          i > 0 ? ", " : "", options.csv_file, success,
          0.06 * static_cast<double>(i), column, column + 1, success);
    }
    text += "\n";
    column += 2;
  }
  return text + "unset multiplot\n";
}

int EvalRexd(const EvalRexdOptions& options) {
  if (!options.csv_file.empty()) {
    RequireFree(options.csv_file, kAnotherTable);
    RequireFree(options.csv_file + ".gp", kAnotherTable);
  }
  const rexd::RexdTask task = LoadRexdTask(options);
  std::vector<RexdTrial> trials;
  for (const double success : options.successes) {
    for (int i = 0; i < options.runs; ++i) {
      trials.push_back({success, options.seed + static_cast<uint64_t>(i)});
    }
  }
  RowStore store(options.rows_file.empty()
                     ? fmt::format("runs/eval-rexd-{}-seed{}.jsonl",
                                   options.teacher, options.seed)
                     : options.rows_file,
                 options.is_resumed);
  std::vector<std::string> keys;
  for (const RexdTrial& trial : trials) keys.push_back(trial.Key());
  DoMissingRuns(
      keys, options.jobs,
      [&](size_t i) { return RunTrial(task, options, trials[i]); }, &store);
  std::string csv = "success,episode";
  for (const char* count : kCounts) csv += fmt::format(",{0},{0}_sd", count);
  csv += ",goal_reached\n";
  size_t num_rows = 0;
  for (const double success : options.successes) {
    std::vector<json> rows;
    for (const RexdTrial& trial : trials) {
      if (trial.success == success && store.Has(trial.Key())) {
        rows.push_back(store.At(trial.Key()));
      }
    }
    num_rows += rows.size();
    if (!rows.empty()) csv += Report(options, success, rows);
  }
  if (!options.csv_file.empty()) {
    WriteNewFile(options.csv_file, csv, kAnotherTable);
    WriteNewFile(options.csv_file + ".gp", PlotOf(options), kAnotherTable);
  }
  std::cout << fmt::format("rows in {} ({} of {} runs)\n",
                           store.path().string(), num_rows, trials.size());
  return num_rows == trials.size() ? 0 : 1;
}

}  // namespace

void AddEvalRexd(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalRexdOptions>();
  CLI::App* command = eval.add_subcommand(
      "rexd",
      "Learn a task from nothing by REX-D, in simulated worlds of several "
      "success rates: actions, demonstrations and explorations in each episode "
      "(Fig. 17). Demonstrations and explorations count as actions.\n"
      "Example: cell eval rexd --runs 100 --csv rexd.csv && gnuplot "
      "rexd.csv.gp");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--task-file", options->task_file,
                      "world, goal and true rules (default: "
                      "learning/placements.rules of the task)");
  command
      ->add_option("--success", options->successes,
                   "success rates of the robot's actions")
      ->delimiter(',')
      ->check(NumberIn(0.01, 1.0))
      ->capture_default_str();
  command
      ->add_option("--teacher", options->teacher,
                   "sure: never fails; noisy: fails like the robot")
      ->check(CLI::IsMember({"sure", "noisy"}))
      ->capture_default_str();
  command->add_flag("!--no-guidance", options->is_guided,
                    "the teacher shows any useful action");
  command->add_flag("!--skip-no-ops", options->explores_no_ops,
                    "do not explore actions that are expected to do nothing");
  command->add_option("--runs", options->runs, "runs for each success rate")
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--episodes", options->episodes, "episodes of a run")
      ->check(NumberIn(1, 1000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "seed of the first run")
      ->check(NumberIn<uint64_t>(0, UINT64_MAX - 1'000'000))
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "number of processes at a time")
      ->check(NumberIn(1, 256))
      ->capture_default_str();
  command->add_option("--rows", options->rows_file,
                      "write one row per run here (default: runs/eval-...)");
  command->add_option("--csv", options->csv_file,
                      "write the table here, and FILE.gp that plots it");
  command->add_flag("--resume", options->is_resumed,
                    "keep the rows of an earlier call and run what is missing");
  command->callback([=] {
    *action = [=] {
      return EvalRexd(*options);
    };
  });
}

}  // namespace cell::cli
