#include <CLI/CLI.hpp>
#include <memory>

#include "cell/command_goal_t.hpp"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

struct GoalOptions {
  OperatorOptions port;
  std::string goal;
};

int CommandGoal(const GoalOptions& options) {
  OperatorPort port(options.port,
                    {"COMMAND_GOAL", "planner", "goal " + options.goal});
  command_goal_t command{};
  command.goal = options.goal;
  return port.Execute(command);
}

}  // namespace

void AddGoal(CLI::App& app, Action* action) {
  auto options = std::make_shared<GoalOptions>();
  CLI::App* command =
      app.add_subcommand("goal",
                         "Change the goal of the current episode of the cell "
                         "running on this network.\n"
                         "Example: cell goal assembled");
  command->add_option("name", options->goal, "a goal of the task's domain.yaml")
      ->required();
  AddOperatorOptions(*command, &options->port);
  command->callback([=] {
    *action = [=] {
      return CommandGoal(*options);
    };
  });
}

}  // namespace cell::cli
