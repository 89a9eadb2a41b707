#include <CLI/CLI.hpp>
#include <memory>

#include "cell/command_confirm_t.hpp"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

struct ConfirmOptions {
  OperatorOptions port;
  std::string action;
};

int CommandConfirm(const ConfirmOptions& options) {
  OperatorPort port(options.port, {"COMMAND_CONFIRM", "planner",
                                   "confirm " + options.action});
  command_confirm_t command{};
  command.action = options.action;
  return port.Execute(command);
}

}  // namespace

void AddConfirm(CLI::App& app, Action* action) {
  auto options = std::make_shared<ConfirmOptions>();
  CLI::App* command = app.add_subcommand(
      "confirm",
      "Let the arms of the cell running on this network do an action that was "
      "learned and that no arm has done yet; the first time at half speed.\n"
      "Example: cell confirm Action1");
  command->add_option("action", options->action, "its name (cell library list)")
      ->required();
  AddOperatorOptions(*command, &options->port);
  command->callback([=] {
    *action = [=] {
      return CommandConfirm(*options);
    };
  });
}

}  // namespace cell::cli
