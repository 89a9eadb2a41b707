#include "common/bus/replay.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "services/cell/commands.h"
#include "services/cell/narrator.h"
#include "services/cell/run_folder.h"
#include "services/cell/service_registry.h"

namespace cell {
namespace {

struct ReplayOptions {
  std::string run;
  std::vector<std::string> services;
  bool is_check = false;
};

void Narrate(const RunLog& log) {
  Narrator narrator;
  for (const auto& [k, tick] : log.ticks()) {
    for (const Message& message : tick.messages) {
      for (const std::string& line : narrator.Tell(message)) {
        std::cout << line << "\n";
      }
    }
  }
}

int CheckServices(const RunFolder& run, const RunLog& log,
                  std::vector<std::string> names) {
  if (names.empty()) {
    for (const auto& entry : run.roster.entries) names.push_back(entry.name);
  }
  int num_different = 0;
  for (const std::string& name : names) {
    std::cout << fmt::format("{:20} ", name) << std::flush;
    run.roster.RequireIndexOf(name);
    const auto factories =
        AllServices(run.deployment, run.demonstration, run.seed);
    const ReplayResult result =
        Replay(log, run.roster, name, factories.at(name));
    if (result.difference) {
      ++num_different;
      std::cout << "DIFFERENT: " << *result.difference << std::endl;
    } else {
      std::cout << fmt::format("{} messages, byte-identical",
                               result.num_messages);
      if (result.gap_after) {
        std::cout << fmt::format(" up to the gap after tick {}",
                                 *result.gap_after);
      }
      std::cout << std::endl;
    }
  }
  return num_different == 0 ? 0 : 1;
}

int RunReplay(const ReplayOptions& options) {
  const RunFolder run = RunFolder::Open(options.run);
  const RunLog log = RunLog::Load(options.run);
  for (const std::string& problem : log.problems()) {
    std::cerr << "log: " << problem << "\n";
  }
  if (!options.is_check) {
    Narrate(log);
    return log.problems().empty() ? 0 : 1;
  }
  const int result = CheckServices(run, log, options.services);
  return log.problems().empty() ? result : 1;
}

}  // namespace

void AddReplay(CLI::App& app, Action* action) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(
      "replay",
      "Tell a recorded run again, or recompute every service's outputs from "
      "its recorded inputs.\nExample: cell replay runs/demo-0001 --check");
  command->add_option("run", options->run, "run folder")->required();
  CLI::Option* check = command->add_flag("--check", options->is_check,
                                         "recompute and compare byte for byte");
  command
      ->add_option("--service", options->services,
                   "only this one (may be repeated)")
      ->needs(check);
  command->callback([=] {
    *action = [=] {
      return RunReplay(*options);
    };
  });
}

}  // namespace cell
