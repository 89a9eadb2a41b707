#include "services/cell/commands/learn_rules.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/experiences/rule_lessons.h"
#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/rules/rule_text.h"
#include "common/text/counted.h"
#include "services/cell/commands/library_commands.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_learn.h"
#include "services/cell/learning/library_experiences.h"
#include "services/cell/learning/run_experiences.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

struct LearnRulesOptions {
  std::string deploy_dir;
  std::string experiences;
  std::string library;
  std::string out;
};

/// What is learned from, and the words that it is in.
struct Lessons {
  RuleWorld world;
  std::vector<rules::Experience> experiences;
};

Lessons LessonsOfLibrary(const std::string& library, const Domain& domain) {
  LibraryExperiences all = ReadLibraryExperiences(LibraryFile(library), domain);
  PrintLeftOut(all);
  return {std::move(all.world), std::move(all.experiences)};
}

Lessons LessonsOfTask(const fs::path& folder, const Domain& domain) {
  RuleWorld world = RuleWorldOf(domain);
  auto experiences = TaskExperiences(folder, world);
  return {std::move(world), std::move(experiences)};
}

int LearnRulesOfTask(const LearnRulesOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  if (!options.out.empty()) RequireFree(options.out, kAnotherOut);
  // The rules to be replaced may be of an older domain.
  const Domain domain = LoadTask(deployment, LearnedRules::kLeaveOut).domain;
  const Lessons lessons =
      options.library.empty()
          ? LessonsOfTask(ExperiencesFolder(options.experiences, deployment),
                          domain)
          : LessonsOfLibrary(options.library, domain);
  const rules::NdrRules rules = LearnRules(
      lessons.experiences, GoalPredicates(domain.goals()), lessons.world);
  std::cout << fmt::format(
                   "{}, {}\n",
                   Counted(static_cast<int64_t>(lessons.experiences.size()),
                           "experience"),
                   Counted(static_cast<int64_t>(rules.rules.size()), "rule"))
            << RulesToShow(rules);
  if (!options.out.empty()) {
    WriteNewFile(options.out, rules::ToText(rules), kAnotherOut);
  }
  return 0;
}

}  // namespace

void AddLearnRules(CLI::App& learn, Action* action) {
  auto options = std::make_shared<LearnRulesOptions>();
  CLI::App* command = learn.add_subcommand(
      "rules",
      "Learn what the task's actions need and do, as noisy deictic rules, from "
      "its experiences, or from those of a library.\n"
      "Example: cell learn rules --out learned.rules\n"
      "Example: cell learn rules --library my.db");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--experiences", options->experiences,
                      "folder of *.experiences (default: experiences/ of the "
                      "task)");
  command
      ->add_option("--library", options->library,
                   "learn from the experiences of this library's file, or of "
                   "a run folder that has one, and of its actions")
      ->excludes("--experiences");
  command->add_option("--out", options->out,
                      "write symbols and rules here, to be shown by cell rules "
                      "show");
  command->callback([=] {
    *action = [=] {
      return LearnRulesOfTask(*options);
    };
  });
}

}  // namespace cell::cli
