#include "services/cell/commands/learn_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/experiences/experience_text.h"
#include "common/experiences/rule_lessons.h"
#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/rules/rule_text.h"
#include "common/text/counted.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/learning/run_experiences.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".experiences";
constexpr char kOtherOut[] = "choose another --out or remove it";

struct LearnRulesOptions {
  std::string deploy_dir;
  std::string experiences;
  std::string out;
};

std::vector<fs::path> ExperienceFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == kExtension) {
        files.push_back(entry.path());
      }
    }
  }
  if (files.empty()) {
    throw std::runtime_error(folder.string() + ": has no file *" + kExtension +
                             "; cell rules record makes them from runs");
  }
  std::ranges::sort(files);
  return files;
}

int LearnRulesOfTask(const LearnRulesOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  if (!options.out.empty()) RequireFree(options.out, kOtherOut);
  const fs::path folder = options.experiences.empty()
                              ? deployment.task_dir / "experiences"
                              : fs::path(options.experiences);
  const Domain domain = LoadTask(deployment).domain;
  const RuleWorld world = RuleWorldOf(domain);
  std::vector<rules::Experience> experiences;
  for (const fs::path& file : ExperienceFilesIn(folder)) {
    for (auto& experience :
         ReadExperiences(TextOfFile(file), file.string(), world)) {
      experiences.push_back(std::move(experience));
    }
  }
  const rules::NdrRules rules =
      LearnRules(experiences, GoalPredicates(domain.goals()), world);
  std::string text;
  for (const rules::Rule& rule : rules.rules) {
    text += "\n" + rules::ToText(rule, *rules.symbols, 2);
  }
  std::cout << fmt::format(
                   "{}, {}\n",
                   Counted(static_cast<int64_t>(experiences.size()),
                           "experience"),
                   Counted(static_cast<int64_t>(rules.rules.size()), "rule"))
            << text;
  if (!options.out.empty()) {
    WriteNewFile(options.out, rules::ToText(rules), kOtherOut);
  }
  return 0;
}

}  // namespace

void AddLearnRules(CLI::App& learn, Action* action) {
  auto options = std::make_shared<LearnRulesOptions>();
  CLI::App* command = learn.add_subcommand(
      "rules",
      "Learn what the task's actions need and do, as noisy deictic rules, from "
      "its experiences.\n"
      "Example: cell learn rules --out learned.rules");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--experiences", options->experiences,
                      "folder of *.experiences (default: experiences/ of the "
                      "task)");
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
