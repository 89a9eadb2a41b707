#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "common/node/cell_files.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/service_units.h"
#include "services/cell/running/unit_environment.h"

namespace cell::cli {
namespace {

/// "tracker" of "cell-tracker.service".
std::string ShortName(const std::string& unit) {
  constexpr size_t kPrefix = 5;
  constexpr size_t kSuffix = 8;
  return unit.substr(kPrefix, unit.size() - kPrefix - kSuffix);
}

// One line per unit; 1 if one of them is not active, or if there is none.
int PrintStatus(const ServiceManager& manager) {
  const auto units = manager.Units();
  if (units.empty()) {
    std::cout << "the cell is down; start it with: cell up\n";
    return 1;
  }
  std::cout << fmt::format("{:22} {:20} {:>8} {:>8} {:>9} {:>8}  since\n",
                           "service", "state", "restarts", "pid", "CPU [s]",
                           "MB");
  for (const ServiceUnit& unit : units) {
    std::cout << fmt::format(
        "{:22} {:20} {:8} {:8} {:9.1f} {:8.1f}  {}\n", ShortName(unit.name),
        unit.state, unit.num_restarts, unit.pid, unit.processor_s,
        static_cast<double>(unit.memory_bytes) / (1 << 20), unit.since);
  }
  const bool is_well = std::all_of(units.begin(), units.end(),
                                   [](const auto& u) { return u.is_active; });
  if (is_well) return 0;
  for (const ServiceUnit& unit : units) {
    if (unit.is_active) continue;
    std::cout << ShortName(unit.name) << ": last output:\n";
    for (const std::string& line : manager.LastLinesOf(unit)) {
      std::cout << "  " << Printable(line) << "\n";
    }
  }
  std::cout << "not all services are active; for more: "
            << manager.JournalCommand() << "\n";
  return 1;
}

int Up(const ServiceManager& manager) {
  const CellFiles files = FindInstalledCellFiles();
  UnitEnvironment::Load(manager.is_user()).Check(files);
  manager.Start();
  return PrintStatus(manager);
}

int Down(const ServiceManager& manager) {
  manager.Stop();
  std::cout << "the cell is down; its logs and state are kept\n";
  return 0;
}

void AddManagerCommand(CLI::App& app, Action* action, const char* name,
                       const char* help, int (*run)(const ServiceManager&)) {
  auto is_user = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(name, help);
  command->add_flag("--user", *is_user,
                    "use your own systemd manager, not the system's");
  command->callback([=] {
    *action = [=] {
      return run(ServiceManager(*is_user));
    };
  });
}

}  // namespace

void AddUp(CLI::App& app, Action* action) {
  AddManagerCommand(app, action, "up",
                    "Start the installed cell, live, under systemd, and wait "
                    "until every service is ready.\nExample: cell up --user",
                    Up);
}

void AddDown(CLI::App& app, Action* action) {
  AddManagerCommand(app, action, "down",
                    "Stop the cell that `cell up` started.\n"
                    "Example: cell down --user",
                    Down);
}

void AddStatus(CLI::App& app, Action* action) {
  AddManagerCommand(
      app, action, "status",
      "Show the state of the cell's services under systemd; exit code 1 "
      "unless all are active.\nExample: cell status --user",
      PrintStatus);
}

}  // namespace cell::cli
