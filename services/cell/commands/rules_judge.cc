#include "services/cell/commands/rules_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/node/cell_files.h"
#include "common/task/shipped_experiences.h"
#include "common/task/task.h"
#include "common/text/counted.h"
#include "common/text/nearest.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/learning/experienced_episodes.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/learning/sufficiency.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

struct JudgeOptions {
  std::string deploy_dir;
  std::string experiences;
  std::string goal;
};

int Judge(const JudgeOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  const Domain domain = LoadTask(deployment).domain;
  const RuleWorld world = RuleWorldOf(domain);
  const fs::path folder = options.experiences.empty()
                              ? deployment.task_dir / kExperiencesFolder
                              : fs::path(options.experiences);
  const Goal& goal = NamedGoal(domain, options.goal);
  std::vector<rules::Experience> experiences;
  std::vector<State> starts;
  for (const ExperiencedEpisode& episode : EpisodesIn(folder, world)) {
    const State start = world.FromWorld(episode.experiences.front().before);
    if (std::ranges::count(starts, start) == 0) starts.push_back(start);
    experiences.insert(experiences.end(), episode.experiences.begin(),
                       episode.experiences.end());
  }
  const Sufficiency judged = JudgeSufficiency(
      LearnedRuleSet(experiences, domain.goals(), world), goal, starts);
  std::cout << fmt::format(
      "{} from {}: ",
      Counted(static_cast<int64_t>(experiences.size()), "experience"),
      Counted(static_cast<int64_t>(starts.size()), "start state"));
  if (judged.is_sufficient) {
    std::cout << fmt::format("they suffice to reach the goal {}\n", goal.name);
    return 0;
  }
  std::cout << fmt::format(
      "they do not suffice to reach the goal {}: from {} there is no plan\n",
      goal.name, Counted(judged.num_without_plan, "start state"));
  for (const Literal& literal : judged.uncovered) {
    std::cout << fmt::format("not covered: {}\n",
                             Show(literal, {}, domain.vocabulary()));
  }
  if (judged.uncovered.empty()) {
    std::cout << "each part of the goal is covered, but not all together\n";
  }
  return 1;
}

}  // namespace

void AddRulesJudge(CLI::App& rules, Action* action) {
  auto options = std::make_shared<JudgeOptions>();
  CLI::App* command = rules.add_subcommand(
      "judge",
      "Judge whether the demonstrations so far suffice to reach a goal, and "
      "which parts of it they do not cover. Exit code 1 if they do not.\n"
      "Example: cell rules judge --goal assembled");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--experiences", options->experiences,
                      "folder of *.experiences (default: experiences/ of the "
                      "task)");
  command->add_option("--goal", options->goal,
                      "of the task (default: its first)");
  command->callback([=] {
    *action = [=] {
      return Judge(*options);
    };
  });
}

}  // namespace cell::cli
