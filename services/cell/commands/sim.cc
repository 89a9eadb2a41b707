#include <CLI/CLI.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "common/node/run_service.h"
#include "services/cell/commands/commands.h"
#include "services/cell/reporting/run_report.h"
#include "services/cell/running/run_options.h"
#include "services/cell/running/service_registry.h"

namespace cell::cli {
namespace {

struct SimOptions {
  RunOptions run;
  std::string deaths_of;
};

// The deaths and joins of a recorded run.
std::vector<SimBus::Outage> OutagesIn(const std::string& run_dir) {
  std::vector<SimBus::Outage> outages;
  const RunLog log = RunLog::Load(run_dir);
  for (const auto& [tick, entry] : log.ticks()) {
    for (const joined_t& joined : entry.manifest.joined) {
      if (joined.death_tick >= 0) {
        outages.push_back({joined.name, joined.death_tick, tick});
      }
    }
  }
  return outages;
}

// A run that cannot begin leaves no folder.
std::unique_ptr<SimBus> MakeBus(const RunFolder& run,
                                std::vector<SimBus::Outage> outages) {
  try {
    return std::make_unique<SimBus>(
        run.roster, AllServices(run.deployment, run.demonstration, run.seed),
        std::move(outages));
  } catch (...) {
    run.Discard();
    throw;
  }
}

int RunSim(const SimOptions& options) {
  std::vector<SimBus::Outage> outages;
  if (!options.deaths_of.empty()) outages = OutagesIn(options.deaths_of);
  const RunFolder run = options.run.CreateFolder("sim");
  const auto bus = MakeBus(run, std::move(outages));
  RunReport report(run, options.run);
  constexpr int32_t kTicksPerReport = 25;
  const auto& stop = StopOnSignals();
  while (bus->Step()) {
    if (stop) run.Stopped();
    if (bus->last_tick().header.tick % kTicksPerReport == 0) report.Follow();
  }
  return report.Finish();
}

}  // namespace

void AddSim(CLI::App& app, Action* action) {
  auto options = std::make_shared<SimOptions>();
  CLI::App* command = app.add_subcommand(
      "sim",
      "Run the whole cell in one process, as fast as possible.\n"
      "Example: cell sim --seed 7 --hash");
  options->run.AddTo(*command);
  command->add_option("--deaths-of", options->deaths_of,
                      "repeat the service deaths of this run folder");
  command->callback([=] {
    *action = [=] {
      return RunSim(*options);
    };
  });
}

}  // namespace cell::cli
