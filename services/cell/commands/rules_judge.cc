#include "services/cell/commands/rules_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/node/cell_files.h"
#include "common/task/task.h"
#include "common/text/counted.h"
#include "common/text/nearest.h"
#include "services/cell/commands/library_commands.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/learning/experienced_episodes.h"
#include "services/cell/learning/library_experiences.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/learning/sufficiency.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

struct JudgeOptions {
  std::string deploy_dir;
  std::string experiences;
  std::string library;
  std::string goal;
};

/// What was shown, and the words that it is in.
struct Shown {
  RuleWorld world;
  std::vector<ExperiencedEpisode> episodes;
};

/// Each demonstration of a library is an episode.
Shown OfLibrary(const std::string& library, const Domain& domain) {
  LibraryExperiences all = ReadLibraryExperiences(LibraryFile(library), domain);
  PrintLeftOut(all);
  Shown shown{std::move(all.world), {}};
  for (size_t i = 0; i < all.experiences.size(); ++i) {
    const std::string& name = all.demonstrations[i];
    if (shown.episodes.empty() || shown.episodes.back().name != name) {
      shown.episodes.push_back({name, {}});
    }
    shown.episodes.back().experiences.push_back(std::move(all.experiences[i]));
  }
  if (shown.episodes.empty()) {
    throw std::runtime_error(
        library +
        ": keeps no experiences of this task; a cell that learns "
        "(cell sim --learn --library FILE) adds them");
  }
  return shown;
}

Shown OfTask(const fs::path& folder, const Domain& domain) {
  RuleWorld world = RuleWorldOf(domain);
  auto episodes = EpisodesIn(folder, world);
  return {std::move(world), std::move(episodes)};
}

int Judge(const JudgeOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  const Domain domain = LoadTask(deployment).domain;
  const Goal& goal = NamedGoal(domain, options.goal);
  const Shown shown =
      options.library.empty()
          ? OfTask(ExperiencesFolder(options.experiences, deployment), domain)
          : OfLibrary(options.library, domain);
  std::vector<rules::Experience> experiences;
  std::vector<State> starts;
  for (const ExperiencedEpisode& episode : shown.episodes) {
    const State start =
        shown.world.FromWorld(episode.experiences.front().before);
    if (std::ranges::count(starts, start) == 0) starts.push_back(start);
    experiences.insert(experiences.end(), episode.experiences.begin(),
                       episode.experiences.end());
  }
  const Sufficiency judged = JudgeSufficiency(
      LearnedRuleSet(experiences, domain.goals(), shown.world), goal, starts);
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
      "Example: cell rules judge --goal assembled\n"
      "Example: cell rules judge --library my.db");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--experiences", options->experiences,
                      "folder of *.experiences (default: experiences/ of the "
                      "task)");
  command
      ->add_option("--library", options->library,
                   "judge what this library's file, or a run folder that has "
                   "one, keeps of its demonstrations")
      ->excludes("--experiences");
  command->add_option("--goal", options->goal,
                      "of the task (default: its first)");
  command->callback([=] {
    *action = [=] {
      return Judge(*options);
    };
  });
}

}  // namespace cell::cli
