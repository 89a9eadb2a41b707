#include "services/cell/commands/eval_rexd_blocks.h"

#include <fmt/format.h>

#include <iostream>

#include "common/files/draft.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/rexd_blocks.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {
namespace {

using nlohmann::json;

void AddEpisodes(const std::vector<rexd::EpisodeCounts>& episodes, json* row) {
  for (const rexd::EpisodeCounts& counts : episodes) {
    (*row)["actions"].push_back(counts.num_actions);
    (*row)["demonstrations"].push_back(counts.num_demonstrations);
    (*row)["explorations"].push_back(counts.num_explorations);
    (*row)["reached"].push_back(counts.is_goal_reached ? 1 : 0);
  }
}

json RunBlocks(const std::vector<rexd::RexdTask>& blocks,
               const rexd::RunParams& params) {
  json row;
  for (const auto& episodes : rexd::RunRexdInTurn(blocks, params)) {
    AddEpisodes(episodes, &row[kCarriedOver]);
  }
  for (const rexd::RexdTask& block : blocks) {
    AddEpisodes(rexd::RunRexd(block, params), &row[kFromScratch]);
  }
  return row;
}

std::vector<double> FloorsOf(const std::vector<rexd::RexdTask>& blocks) {
  std::vector<double> floors;
  for (const rexd::RexdTask& block : blocks) {
    rexd::PlanningTeacher teacher(block, 1, {}, 0);
    floors.push_back(teacher.DistanceFrom(block.initial).value_or(0));
  }
  return floors;
}

void WriteBlocksFigure(const EvalRexdOptions& options, const BlockPlan& plan,
                       const std::vector<BlockGroup>& groups) {
  const std::string png = options.csv_file + ".png";
  WriteNewFile(options.csv_file, BlocksCsv(plan, groups), kAnotherTable);
  const std::string problem =
      RunGnuplot(BlocksPlot(plan, groups, options.csv_file, png));
  std::cout << fmt::format("written: {}\n{}\n", options.csv_file,
                           problem.empty() ? "written: " + png : problem);
}

void ReportBlocks(const EvalRexdOptions& options, const BlockPlan& plan,
                  const std::vector<BlockGroup>& groups) {
  for (const BlockGroup& group : groups) {
    std::cout << fmt::format("success {}, {} runs, teacher {}\n{}",
                             group.success, group.rows.size(), options.teacher,
                             BlocksText(plan, group));
    for (const RexdStatement& statement : CheckBlockStatements(plan, group)) {
      std::cout << fmt::format("{:5} {}: {}\n",
                               statement.is_true ? "true" : "false",
                               statement.text, statement.found);
    }
  }
}

}  // namespace

int EvalBlocks(const EvalRexdOptions& options) {
  const std::vector<rexd::RexdTask> blocks = LoadBlocks(options);
  BlockPlan plan{{}, FloorsOf(blocks), options.episodes};
  for (const std::string& block : options.blocks) {
    plan.names.push_back(NameOfBlock(block));
  }
  const std::vector<RexdTrial> trials = TrialsOf(options);
  RowStore store(RowsFile(options), options.is_resumed);
  std::vector<std::string> keys;
  for (const RexdTrial& trial : trials) keys.push_back(trial.Key());
  DoMissingRuns(
      keys, options.jobs,
      [&](size_t i) { return RunBlocks(blocks, ParamsOf(options, trials[i])); },
      &store);
  size_t num_rows = 0;
  std::vector<BlockGroup> groups;
  for (const double success : options.successes) {
    BlockGroup group{success, {}};
    for (const RexdTrial& trial : trials) {
      if (trial.success == success && store.Has(trial.Key())) {
        group.rows.push_back(store.At(trial.Key()));
      }
    }
    num_rows += group.rows.size();
    if (!group.rows.empty()) groups.push_back(std::move(group));
  }
  ReportBlocks(options, plan, groups);
  if (!options.csv_file.empty()) WriteBlocksFigure(options, plan, groups);
  std::cout << fmt::format("rows in {} ({} of {} runs)\n",
                           store.path().string(), num_rows, trials.size());
  return num_rows == trials.size() ? 0 : 1;
}

}  // namespace cell::cli
