#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
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
  OperatorPort port(options.port);
  command_goal_t command{};
  command.goal = options.goal;
  port.Send("COMMAND_GOAL", command);
  std::cout << fmt::format("asked the cell for the goal {}, by {:.2f} s\n",
                           options.goal,
                           static_cast<double>(port.deadline_utime()) * 1e-6);
  return 0;
}

}  // namespace

void AddGoal(CLI::App& app, Action* action) {
  auto options = std::make_shared<GoalOptions>();
  CLI::App* command = app.add_subcommand(
      "goal",
      "Give the episode of a cell that runs on this network another goal.\n"
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
