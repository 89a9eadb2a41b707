#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cell/command_mode_t.hpp"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

int CommandMode(const OperatorOptions& options, int8_t action,
                const std::string& name) {
  OperatorPort port(options, {"COMMAND_MODE", "supervisor", name});
  command_mode_t command{};
  command.action = action;
  return port.Execute(command);
}

void AddModeCommand(CLI::App& app, Action* action, int8_t mode,
                    const char* name, const char* help) {
  auto options = std::make_shared<OperatorOptions>();
  CLI::App* command = app.add_subcommand(name, help);
  AddOperatorOptions(*command, options.get());
  command->callback([=, name = std::string(name)] {
    *action = [=] {
      return CommandMode(*options, mode, name);
    };
  });
}

}  // namespace

void AddHold(CLI::App& app, Action* action) {
  AddModeCommand(app, action, command_mode_t::HOLD, "hold",
                 "Stop the arms of the cell running on this network until "
                 "`cell resume`. Not a certified safety function.\n"
                 "Example: cell hold");
}

void AddResume(CLI::App& app, Action* action) {
  AddModeCommand(app, action, command_mode_t::RESUME, "resume",
                 "Resume a cell after `cell hold` or a protective stop.\n"
                 "Example: cell resume --deadline 5");
}

}  // namespace cell::cli
