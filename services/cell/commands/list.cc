#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "common/node/cell_files.h"
#include "common/task/task.h"
#include "common/text/nearest.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/task_variant.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

using Names = std::vector<std::string>;

Names TasksBeside(const std::filesystem::path& task_dir) {
  Names names;
  for (const auto& entry :
       std::filesystem::directory_iterator(task_dir.parent_path())) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

/// Those of a person and those in which the robot works.
std::pair<Names, Names> DemonstrationsOf(const Deployment& deployment,
                                         const Task& task) {
  const auto demonstrations = vtb::Demonstrations::FromConfig(
      deployment.OfTask("demonstrators.yaml"), task.parts);
  Names by_person, by_robot;
  for (const auto& [name, script] : demonstrations.scripts) {
    (script.agent == "robot" ? by_robot : by_person).push_back(name);
  }
  return {by_person, by_robot};
}

void Print(const std::string& what, const Names& names) {
  std::cout << Printable(fmt::format(
                   "{:28} {}", what,
                   names.empty() ? "none"
                                 : fmt::format("{}", fmt::join(names, ", "))))
            << "\n";
}

/// @param evaluations  subcommands of `cell eval`
int RunList(const std::string& deploy_dir, const Names& evaluations) {
  const CellFiles files = FindCellFiles(deploy_dir);
  const Task task = LoadTask(files.deployment);
  const auto [by_person, by_robot] = DemonstrationsOf(files.deployment, task);
  Print("tasks", TasksBeside(files.deployment.task_dir));
  const std::string name = files.deployment.task_dir.filename().string();
  Print("of " + name + ": goals", NamesIn(task.domain.goals(), &Goal::name));
  Print("  demonstrations, person", by_person);
  Print("  demonstrations, robot", by_robot);
  Print("  variants", VariantsOf(files.deployment.task_dir));
  Print("  actions", NamesIn(task.domain.actions(), &cell::Action::name));
  Print("services", NamesIn(files.roster.entries, &Roster::Entry::name));
  Print("evaluations", evaluations);
  return 0;
}

}  // namespace

void AddList(CLI::App& app, Action* action) {
  auto deploy_dir = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "list",
      "List the names that commands accept: tasks, goals, demonstrations, "
      "variants, actions, services, evaluations.\nExample: cell list");
  command->add_option("--deploy", *deploy_dir,
                      "folder with config/ and tasks/");
  CLI::App* all = &app;  // evaluations are added after this command
  command->callback([=] {
    *action = [=] {
      Names evaluations;
      for (const CLI::App* one :
           all->get_subcommand("eval")->get_subcommands({})) {
        evaluations.push_back(one->get_name());
      }
      return RunList(*deploy_dir, evaluations);
    };
  });
}

}  // namespace cell::cli
