#include <CLI/CLI.hpp>
#include <memory>

#include "cell/command_name_t.hpp"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

struct NameOptions {
  OperatorOptions port;
  std::string name;
  bool is_undone = false;
};

int CommandName(const NameOptions& options) {
  OperatorPort port(options.port,
                    {"COMMAND_NAME", "recognizer", "name " + options.name});
  command_name_t command{};
  command.name = options.name;
  command.is_undone = options.is_undone ? 1 : 0;
  return port.Execute(command);
}

}  // namespace

void AddName(CLI::App& app, Action* action) {
  auto options = std::make_shared<NameOptions>();
  CLI::App* command = app.add_subcommand(
      "name",
      "Tell the cell running on this network what the action is called that "
      "was just shown. It must be learning (recognizer.yaml).\n"
      "Example: cell name PlaceBolt");
  command->add_option("name", options->name, "of an action of the task")
      ->required();
  command->add_flag("--undone", options->is_undone,
                    "what was shown undoes this action");
  AddOperatorOptions(*command, &options->port);
  command->callback([=] {
    *action = [=] {
      return CommandName(*options);
    };
  });
}

}  // namespace cell::cli
