#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "common/planning/excuse.h"
#include "common/planning/ground_model.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/planner.h"
#include "common/planning/rollout.h"
#include "common/ppddl/problem.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/search_file.h"
#include "services/cell/reporting/plan_picture.h"
#include "services/cell/reporting/plan_report.h"

namespace cell::cli {
namespace {

using planning::Plan;

constexpr char kAnotherFile[] = "choose another file or remove it";
constexpr int kMaxRollouts = 10'000'000;
/// Without --fewest: a second or two.
constexpr int64_t kMinimizeExpansions = 50'000;

struct PlanOptions {
  std::vector<std::string> files;  // domain, problem
  planning::Planner::Params params;
  bool is_fewest = false;
  std::string search_file;  // empty: none
  bool is_resumed = false;
  int rollouts = 0;
  uint64_t seed = 1;
  std::string json_file;
  std::string picture_file;
};

std::string TextOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!std::filesystem::is_regular_file(path) || !(text << file.rdbuf())) {
    throw std::runtime_error(path + ": cannot be read; name a PPDDL file");
  }
  return text.str();
}

int64_t PeakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return int64_t{usage.ru_maxrss} * 1024;
}

planning::GroundTask Ground(const ppddl::Domain& domain,
                            const ppddl::Problem& problem,
                            const std::string& file) {
  Result<planning::GroundTask> task = planning::GroundPpddl(domain, problem);
  if (!task) throw std::runtime_error(file + ": " + task.reason());
  return *std::move(task);
}

void AddExcuses(const ppddl::Domain& domain, const ppddl::Problem& problem,
                PlanReport* report) {
  planning::GroundingLimits limits;
  limits.max_actions = 100'000;
  const auto task = planning::GroundPpddl(
      domain, problem, planning::ConstantAtoms::kKeep, limits);
  if (!task) return;  // too large to ask what would help
  for (const auto& excuse : FindExcuses(*task).excuses) {
    std::vector<std::string> changes;
    for (const auto& change : excuse.changes) {
      changes.push_back(Show(change.literal, task->atoms));
    }
    if (report->excuses.empty()) {
      for (const auto& subgoal : excuse.subgoals) {
        report->subgoals.push_back(Show(subgoal, task->atoms));
      }
    }
    report->changes.push_back(std::move(changes));
    report->excuses.push_back(Explain(excuse, *task));
  }
}

/// Finds the plan, in a search that is kept in the file of --save.
Plan FindPlan(const PlanOptions& options, const std::string& question,
              const planning::GroundModel& model, planning::Planner* planner) {
  if (options.search_file.empty()) return planner->Find(model.initial());
  SearchFile file(options.search_file, question, options.is_resumed);
  file.Restore(planner);
  Plan plan = planner->Find(model.initial(), file.SaveWhile(planner));
  file.ThrowIfStopped();
  return plan;
}

PlanReport MakePlan(const PlanOptions& options) {
  const std::string domain_text = TextOf(options.files[0]);
  const std::string problem_text = TextOf(options.files[1]);
  const ppddl::Domain domain =
      ppddl::ParseDomain(domain_text, options.files[0]);
  const ppddl::Problem problem =
      ppddl::ParseProblem(problem_text, options.files[1], domain);
  const auto model = std::make_shared<planning::GroundModel>(
      Ground(domain, problem, options.files[1]));
  planning::Planner::Params params = options.params;
  if (!options.is_fewest) params.max_minimize_expansions = kMinimizeExpansions;
  planning::Planner planner(model, params);
  PlanReport report;
  report.domain = domain.name;
  report.problem = problem.name;
  const std::string question =
      fmt::format("{}\n{}\n{}", domain_text, problem_text, params.precision);
  report.plan = FindPlan(options, question, *model, &planner);
  if (report.plan.status == Plan::Status::kNoPlan) {
    AddExcuses(domain, problem, &report);
  }
  if (options.rollouts > 0 && report.plan.status == Plan::Status::kFound) {
    report.rollouts = RollOut(*model, planner, model->initial(),
                              options.rollouts, options.seed);
  }
  report.peak_bytes = PeakBytes();
  return report;
}

/// Checks, before long work, that its results can be written.
void RequireFreeResults(const PlanOptions& options, const std::string& json) {
  if (!json.empty()) RequireFree(json, kAnotherFile);
  if (!options.picture_file.empty()) {
    RequireFree(options.picture_file, kAnotherFile);
  }
  RequireDistinct({json, options.picture_file, options.search_file});
}

int RunPlan(const PlanOptions& options) {
  const std::string json_file =
      options.json_file == "-" ? "" : options.json_file;
  RequireFreeResults(options, json_file);
  const PlanReport report = MakePlan(options);
  const std::string json = ToJson(report).dump(2) + "\n";
  std::cout << (options.json_file == "-" ? json : ToText(report));
  if (!json_file.empty()) WriteNewFile(json_file, json, kAnotherFile);
  if (!options.picture_file.empty()) {
    WriteNewFile(options.picture_file, DrawPlan(report), kAnotherFile);
  }
  const bool is_found = report.plan.status == Plan::Status::kFound ||
                        report.plan.status == Plan::Status::kGoalReached;
  return is_found ? 0 : 1;
}

}  // namespace

void AddPlan(CLI::App& app, Action* action) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = app.add_subcommand(
      "plan",
      "Plan for a PPDDL problem: the highest probability of reaching the goal, "
      "with a proven interval, then the fewest actions to be expected, proven "
      "if that is soon done; or why there is no plan and what would allow one. "
      "Costs and rewards are ignored. Exit code 1 without a plan.\n"
      "Example: cell plan --ppddl domain.pddl problem.pddl --json plan.json\n"
      "Example: cell plan --ppddl domain.pddl problem.pddl --fewest --save "
      "search --resume");
  command->add_option("--ppddl", options->files, "domain file and problem file")
      ->expected(2)
      ->required();
  command
      ->add_option("--max-expansions", options->params.max_expansions,
                   "states whose successors are computed at most")
      ->check(NumberIn<int64_t>(1))
      ->capture_default_str();
  command
      ->add_option("--precision", options->params.precision,
                   "width of the probability's interval that is good enough")
      ->check(NumberIn<double>(1e-12, 1))
      ->capture_default_str();
  command->add_flag(
      "--fewest", options->is_fewest,
      fmt::format("prove that no plan of the same probability needs fewer "
                  "actions, within --max-expansions; otherwise at most {} "
                  "expansions go into that, and the result says whether it "
                  "was proven",
                  kMinimizeExpansions));
  CLI::Option* save = command->add_option(
      "--save", options->search_file,
      "keep the search here (about as large as its memory), now and then, at "
      "the end and on Ctrl-C, so that it can go on");
  command
      ->add_flag("--resume", options->is_resumed,
                 "go on from the file of --save, if it is there, as if the "
                 "search had not been interrupted; or with more "
                 "--max-expansions")
      ->needs(save);
  command->add_flag("--alternatives", options->params.solve_alternatives,
                    "the same precision for every first action");
  command
      ->add_option("--rollouts", options->rollouts,
                   "execute the plan so often, with random outcomes")
      ->check(NumberIn<int>(1, kMaxRollouts));
  command->add_option("--seed", options->seed, "of the outcomes")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  command
      ->add_option("--json", options->json_file,
                   "file for the result; without a name or as - it is printed "
                   "instead of the text")
      ->expected(0, 1)
      ->default_str("-");
  command->add_option("--picture", options->picture_file,
                      "SVG file for a drawing of the plan");
  command->callback([=] {
    *action = [=] {
      return RunPlan(*options);
    };
  });
}

}  // namespace cell::cli
