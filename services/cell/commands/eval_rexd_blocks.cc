#include "services/cell/commands/eval_rexd_blocks.h"

#include <fmt/format.h>

#include <iostream>

#include "services/cell/commands/rexd_trials.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/rexd_blocks.h"

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

void ReportBlocks(const EvalRexdOptions& options, const BlockPlan& plan,
                  const std::vector<RexdGroup>& groups) {
  for (const RexdGroup& group : groups) {
    std::cout << fmt::format("success {}, {} runs, teacher {}\n{}",
                             group.success, group.rows.size(), options.teacher,
                             BlocksText(plan, group));
    std::cout << ToText(CheckBlockStatements(plan, group));
  }
}

}  // namespace

int EvalBlocks(const EvalRexdOptions& options) {
  RowIdentity identity = IdentityOf(options);
  const std::vector<rexd::RexdTask> blocks = LoadBlocks(options, &identity);
  BlockPlan plan{{}, FloorsOf(blocks), options.episodes};
  for (const std::string& block : options.blocks) {
    plan.names.push_back(NameOfBlock(block));
  }
  const RexdTrialRows rows = RunTrials(
      options, identity, BlocksRowShape(plan), [&](const RexdTrial& trial) {
        return RunBlocks(blocks, ParamsOf(options, trial));
      });
  ReportBlocks(options, plan, rows.groups);
  if (!options.csv_file.empty()) {
    std::cout << WritePlottedTable(
        options.csv_file, BlocksCsv(plan, rows.groups),
        BlocksPlot(plan, rows.groups, options.csv_file,
                   PictureOf(options.csv_file)),
        kAnotherTable);
  }
  std::cout << ToText(rows);
  return rows.is_complete() ? 0 : 1;
}

}  // namespace cell::cli
