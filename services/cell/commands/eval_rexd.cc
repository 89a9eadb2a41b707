#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/eval_rexd_blocks.h"
#include "services/cell/commands/eval_rexd_curve.h"
#include "services/cell/commands/eval_rexd_options.h"
#include "services/cell/commands/rexd_trials.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/rexd_statements.h"

namespace cell::cli {
namespace {

using nlohmann::json;

json RunTrial(const rexd::RexdTask& task, const EvalRexdOptions& options,
              const RexdTrial& trial) {
  json row = {{"success", trial.success}, {"seed", trial.seed}};
  rexd::FrozenScore frozen;
  for (const rexd::EpisodeCounts& counts :
       rexd::RunRexd(task, ParamsOf(options, trial), &frozen)) {
    row["actions"].push_back(counts.num_actions);
    row["demonstrations"].push_back(counts.num_demonstrations);
    row["explorations"].push_back(counts.num_explorations);
    row["reached"].push_back(counts.is_goal_reached ? 1 : 0);
    row["dead_ends"].push_back(counts.is_dead_end ? 1 : 0);
    row["fatal_rules"].push_back(counts.fatal_rule.value_or(-1));
    row["shown_falls"].push_back(counts.is_fall_demonstrated ? 1 : 0);
  }
  row["states"] = frozen.num_states;
  row["valid"] = frozen.num_valid;
  row["probabilities"] = json::object();
  for (const auto& [action, expectation] : frozen.expectations) {
    row["probabilities"][task.world->symbols()[action].name] = {
        expectation.probability, expectation.num_experiences};
  }
  return row;
}

/// Prints the figures of all success rates and what they say of the paper.
void Report(const EvalRexdOptions& options, const rexd::RexdTask& task,
            const std::vector<RexdGroup>& groups) {
  rexd::PlanningTeacher teacher(task, 1, {}, 0);
  const double floor = teacher.DistanceFrom(task.initial).value_or(0);
  for (const RexdGroup& group : groups) {
    std::cout << fmt::format("success {}, {} runs, teacher {}\n{}",
                             group.success, group.rows.size(), options.teacher,
                             RexdText(group, options.episodes, floor));
  }
  std::cout << ToText(CheckRexdStatements(groups, options.episodes, floor));
}

/// The curve, with the options that both evaluations have.
int EvalCurve(const EvalRexdOptions& options, LearningCurveOptions curve) {
  curve.runs = options.runs;
  curve.seed = options.seed;
  curve.jobs = options.jobs;
  curve.rows_file = options.rows_file;
  curve.csv_file = options.csv_file;
  curve.is_resumed = options.is_resumed;
  return EvalLearningCurve(curve);
}

int EvalEpisodes(const EvalRexdOptions& options) {
  RowIdentity identity = IdentityOf(options);
  const rexd::RexdTask task = LoadRexdTask(options, &identity);
  const RexdTrialRows rows = RunTrials(
      options, identity, RexdRowShape(options.episodes),
      [&](const RexdTrial& trial) { return RunTrial(task, options, trial); });
  Report(options, task, rows.groups);
  if (!options.csv_file.empty()) {
    std::cout << WritePlottedTable(
        options.csv_file, RexdCsv(rows.groups, options.episodes),
        RexdPlot(rows.groups, options.episodes, options.csv_file,
                 PictureOf(options.csv_file)),
        kAnotherTable);
  }
  std::cout << ToText(rows);
  return rows.is_complete() ? 0 : 1;
}

int EvalRexd(const EvalRexdOptions& options,
             const LearningCurveOptions& curve) {
  if (!curve.domain_file.empty()) return EvalCurve(options, curve);
  RequireDistinct({options.csv_file, options.rows_file});
  if (!options.csv_file.empty()) {
    RequireFree(options.csv_file, kAnotherTable);
    RequireFree(PictureOf(options.csv_file), kAnotherTable);
  }
  return options.blocks.empty() ? EvalEpisodes(options) : EvalBlocks(options);
}

void AddCurveOptions(CLI::App* command, LearningCurveOptions* curve) {
  CLI::Option* domain =
      command->add_option("--ppddl", curve->domain_file,
                          "a domain to learn without a teacher: how many test "
                          "problems are solved after how many actions");
  const auto add = [&](CLI::Option* option) {
    option->needs(domain);
    return option;
  };
  domain->needs(add(command->add_option("--learn-in", curve->learn_file,
                                        "the problem whose world is learned "
                                        "in, from its initial state on")));
  domain->needs(add(command->add_option(
      "--test-on", curve->test_files,
      "problems to plan and act in by the rules that were learned")));
  add(command->add_option("--actions", curve->num_actions, "actions of a run"))
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  add(command->add_option("--every", curve->interval,
                          "actions between two tests"))
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
}

}  // namespace

void AddEvalRexd(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalRexdOptions>();
  auto curve = std::make_shared<LearningCurveOptions>();
  CLI::App* command = eval.add_subcommand(
      "rexd",
      "Learn a task from nothing by REX-D, in simulated worlds of several "
      "success rates: actions, demonstrations and explorations in each episode "
      "(Fig. 17), how good the learned rules are, and whether what the paper "
      "says of the figure is true. Demonstrations and explorations count as "
      "actions. Where actions may lead to a dead end: how often the robot's "
      "did "
      "so again. The same kind of dead end is one entered by the same action "
      "under the same relevant conditions (one true rule), whatever its "
      "objects "
      "and outcome; the first one of another kind is no repetition.\n"
      "Example: cell eval rexd --runs 300 --csv rexd.csv\n"
      "Example: cell eval rexd --blocks FIRST,SECOND "
      "--success 1,0.4 --csv blocks.csv\n"
      "Example: cell eval rexd --ppddl domain.pddl --learn-in learn.pddl "
      "--test-on test_*.pddl --runs 10 --csv curve.csv");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--task-file", options->task_file,
                      "world, goal and true rules (default: "
                      "learning/placements.rules of the task; with --blocks "
                      "learning/changed_tasks.rules)");
  command
      ->add_option("--blocks", options->blocks,
                   "changed tasks to learn one after the other, --episodes of "
                   "each, and beside it each from scratch: files with what "
                   "differs from the task file at the start (changes: ...) and "
                   "the goal, or names of such files in learning/ of the task")
      ->delimiter(',');
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
  command
      ->add_option("--without", options->without,
                   "leave out: guidance (the teacher shows any useful action), "
                   "subgoals, alternatives (of rules), types (any objects for "
                   "an action), fits (the predicate)")
      ->delimiter(',')
      ->check(CLI::IsMember(
          {"guidance", "subgoals", "alternatives", "types", "fits"}));
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
                      "write the table here, and FILE.png that plots it");
  command->add_flag("--resume", options->is_resumed,
                    "keep the rows of an earlier call and run what is missing");
  AddCurveOptions(command, curve.get());
  command->callback([=] {
    *action = [=] {
      return EvalRexd(*options, *curve);
    };
  });
}

}  // namespace cell::cli
