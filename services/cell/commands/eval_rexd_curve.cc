#include "services/cell/commands/eval_rexd_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "common/files/draft.h"
#include "common/rexd/explorer.h"
#include "common/rexd/ppddl_import.h"
#include "common/rexd/test_run.h"
#include "common/rules/rule_text.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/learning_curve.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kAnotherCurve[] = "choose another --csv or remove it";

struct Problems {
  rexd::RexdTask learning;
  std::vector<rexd::RexdTask> tests;
};

/// Adds the files, and what else changes a row but its seed, to the identity of
/// the rows.
Problems LoadProblems(const LearningCurveOptions& options,
                      RowIdentity* identity) {
  identity->options = {{"--actions", std::to_string(options.num_actions)},
                       {"--every", std::to_string(options.interval)}};
  const auto read = [&](const std::string& file, const std::string& name) {
    const std::string text = TextOfFile(file);
    identity->AddFile(name, text);
    return rexd::PpddlText{text, file};
  };
  const rexd::PpddlText domain = read(options.domain_file, "the domain file");
  const auto load = [&](const std::string& file, const std::string& name) {
    return rexd::ParseRexdTask(rexd::TaskOfPpddl(domain, read(file, name)),
                               file);
  };
  Problems problems{load(options.learn_file, "the file of --learn-in"), {}};
  for (const std::string& file : options.test_files) {
    problems.tests.push_back(load(
        file, fmt::format("file {} of --test-on", problems.tests.size() + 1)));
  }
  return problems;
}

int NumSolved(const rules::NdrRules& rules, const Problems& problems) {
  return static_cast<int>(
      std::ranges::count_if(problems.tests, [&](const rexd::RexdTask& task) {
        return rexd::RunTest(rules, task).is_goal_reached;
      }));
}

json LearnAndTest(const Problems& problems, const LearningCurveOptions& options,
                  uint64_t seed) {
  const rexd::RexdTask& task = problems.learning;
  rules::RandomNumbers random(seed);
  rexd::Explorer::Params params;
  params.seed = random.Next();
  rexd::Explorer explorer(task, params);
  rules::WorldState state = task.initial;
  json row = {{"seed", seed}, {"solved", json::array()}};
  std::string tested;
  int num_solved = 0;
  for (int i = 1; i <= options.num_actions; ++i) {
    const rules::GroundAct act = explorer.Choose(state);
    rules::WorldState after =
        rules::Simulate(task.truth, *task.world, act, state, &random);
    explorer.Observe({state, act, after});
    state = std::move(after);
    if (i % options.interval != 0) continue;
    const std::string now = rules::ToText(explorer.rules());
    if (now != tested) num_solved = NumSolved(explorer.rules(), problems);
    tested = now;
    row["solved"].push_back(num_solved);
  }
  row["rules"] = tested;
  return row;
}

void PrintRuns(const std::vector<json>& rows,
               const LearningCurveOptions& options) {
  const int num_problems = static_cast<int>(options.test_files.size());
  std::vector<int> masters;
  for (const json& row : rows) {
    const int actions = ActionsToMaster(row, options.interval, num_problems);
    if (actions >= 0) masters.push_back(actions);
  }
  std::ranges::sort(masters);
  std::cout << fmt::format("all {} problems solved in {} of {} runs",
                           num_problems, masters.size(), rows.size());
  if (!masters.empty()) {
    std::cout << fmt::format(", from {} actions on at best, {} at worst",
                             masters.front(), masters.back());
  }
  std::cout << "\n";
}

void WriteCurve(const std::vector<CurvePoint>& curve,
                const std::string& csv_file) {
  std::cout << WritePlottedTable(csv_file, CurveCsv(curve),
                                 CurvePlot(csv_file, PictureOf(csv_file)),
                                 kAnotherCurve);
}

std::string RowsFile(const LearningCurveOptions& options) {
  if (!options.rows_file.empty()) return options.rows_file;
  const std::string domain =
      std::filesystem::path(options.domain_file).stem().string();
  return fmt::format("runs/eval-rexd-curve-{}-seed{}.jsonl", domain,
                     options.seed);
}

}  // namespace

int EvalLearningCurve(const LearningCurveOptions& options) {
  RequireDistinct({options.csv_file, options.rows_file});
  if (!options.csv_file.empty()) {
    RequireFree(options.csv_file, kAnotherCurve);
    RequireFree(PictureOf(options.csv_file), kAnotherCurve);
  }
  RowIdentity identity{"eval rexd --ppddl", {}, {}};
  const Problems problems = LoadProblems(options, &identity);
  RowStore store(
      {.path = RowsFile(options),
       .is_resumed = options.is_resumed,
       .identity = std::move(identity),
       .shape = CurveRowShape(options.num_actions / options.interval)});
  std::vector<std::string> keys;
  for (int i = 0; i < options.runs; ++i) {
    keys.push_back(std::to_string(options.seed + static_cast<uint64_t>(i)));
  }
  DoMissingRuns(
      keys, options.jobs,
      [&](size_t i) {
        return LearnAndTest(problems, options, options.seed + i);
      },
      &store);
  const std::vector<json> rows = store.RowsOf(keys);
  const auto curve = LearningCurve(rows, options.interval,
                                   static_cast<int>(problems.tests.size()));
  std::cout << CurveText(curve);
  PrintRuns(rows, options);
  if (!options.csv_file.empty()) WriteCurve(curve, options.csv_file);
  std::cout << fmt::format("rows in {} ({} of {} runs)\n",
                           store.path().string(), rows.size(), keys.size());
  return rows.size() == keys.size() ? 0 : 1;
}

}  // namespace cell::cli
