#include <CLI/CLI.hpp>
#include <memory>

#include "cell/command_episode_t.hpp"
#include "common/node/number_option.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

struct EpisodeOptions {
  OperatorOptions port;
  std::string action = "end";
  std::string demonstration;
  int64_t seed = 1;
};

int CommandEpisode(const EpisodeOptions& options) {
  OperatorPort port(options.port, {"COMMAND_EPISODE", "the clock",
                                   "episode " + options.action});
  command_episode_t command{};
  command.action = options.action == "start" ? command_episode_t::START
                                             : command_episode_t::END;
  command.demonstration = options.demonstration;
  command.seed = options.seed;
  return port.Execute(command);
}

}  // namespace

void AddEpisode(CLI::App& app, Action* action) {
  auto options = std::make_shared<EpisodeOptions>();
  CLI::App* command = app.add_subcommand(
      "episode",
      "Begin or end an episode of the cell running on this network (a `cell "
      "demo` has its own network).\n"
      "Example: cell episode start --demonstration assembly --seed 3");
  command->add_option("action", options->action, "start or end")
      ->required()
      ->check(CLI::IsMember({"start", "end"}));
  command->add_option("--demonstration", options->demonstration,
                      "for start: demonstration script of the task");
  command->add_option("--seed", options->seed, "seed of its random numbers")
      ->check(NumberIn<int64_t>(0))
      ->capture_default_str();
  AddOperatorOptions(*command, &options->port);
  command->callback([=] {
    *action = [=] {
      return CommandEpisode(*options);
    };
  });
}

}  // namespace cell::cli
