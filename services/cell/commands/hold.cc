#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cell/command_mode_t.hpp"
#include "services/cell/commands/commands.h"
#include "services/cell/running/operator_port.h"

namespace cell::cli {
namespace {

int CommandMode(const OperatorOptions& options, int8_t action) {
  OperatorPort port(options);
  command_mode_t command{};
  command.action = action;
  port.Send("COMMAND_MODE", command);
  std::cout << fmt::format("asked the cell to {}, by {:.2f} s\n",
                           action == command_mode_t::HOLD ? "hold" : "go on",
                           static_cast<double>(port.deadline_utime()) * 1e-6);
  return 0;
}

void AddModeCommand(CLI::App& app, Action* action, int8_t mode,
                    const char* name, const char* help) {
  auto options = std::make_shared<OperatorOptions>();
  CLI::App* command = app.add_subcommand(name, help);
  AddOperatorOptions(*command, options.get());
  command->callback([=] {
    *action = [=] {
      return CommandMode(*options, mode);
    };
  });
}

}  // namespace

void AddHold(CLI::App& app, Action* action) {
  AddModeCommand(app, action, command_mode_t::HOLD, "hold",
                 "Stop the arms of a cell that runs on this network, until "
                 "`cell resume`. No certified safety function.\n"
                 "Example: cell hold");
}

void AddResume(CLI::App& app, Action* action) {
  AddModeCommand(app, action, command_mode_t::RESUME, "resume",
                 "Let a cell go on after `cell hold` or a protective stop.\n"
                 "Example: cell resume --deadline 5");
}

}  // namespace cell::cli
