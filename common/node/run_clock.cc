#include "common/node/run_clock.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "common/bus/lcm_clock.h"
#include "common/bus/lcm_live.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/node/run_service.h"
#include "common/node/service_arguments.h"
#include "common/node/service_manager.h"

namespace cell {
namespace {

void RunLockstep(const ServiceArguments& arguments, const Roster& roster,
                 const std::string& name, const ServiceFactory& factory,
                 const LcmClockOptions& options) {
  const LcmClockSummary summary =
      RunLcmClock(arguments.address.Get(), roster, factory, options,
                  ReportToServiceManager(), StopOnSignals());
  std::cerr << fmt::format(
      "{}: {} ticks in {:.3f} s, {} TICKs repeated, {} late, {} refused\n",
      name, summary.num_ticks, summary.elapsed_s, summary.num_repeats,
      summary.num_late_ticks, summary.num_refused);
}

}  // namespace

int RunClock(const std::string& name, int argc, char** argv,
             const ClockServiceMaker& maker) {
  CLI::App app("Runs the cell's world, " + name +
               ", over LCM: as the clock of a cell in lockstep, or live.\n"
               "Example: " +
               name + " --seed 7 --pace realtime");
  ServiceArguments arguments;
  arguments.AddTo(app);
  std::string demonstration;
  uint64_t seed = 1;
  std::string pace = "fast";
  double giveup_s = 0;
  app.add_option("--demonstration", demonstration, "script of the task");
  app.add_option("--seed", seed)
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  app.add_option("--pace", pace, "as fast as the machine allows, or realtime")
      ->check(CLI::IsMember({"fast", "realtime"}))
      ->capture_default_str();
  app.add_option(
         "--giveup", giveup_s,
         "end when a service is silent for this long [s]; 0: wait forever")
      ->check(NumberIn(0., 86400.));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return ReportFailures(name, [&] {
    CellFiles files = FindCellFiles(arguments.deploy_dir);
    files.deployment.run_dir = arguments.run_dir;
    files.deployment.is_live = arguments.is_live;
    files.deployment.has_operator = arguments.is_live;
    const ServiceFactory factory = [&](Bus& bus) {
      return maker(bus, files.deployment, demonstration, seed);
    };
    if (arguments.is_live) {
      RunLcmLive(arguments.address.Get(), files.roster, name, factory,
                 arguments.StateDir(), ReportToServiceManager(),
                 StopOnSignals());
    } else {
      LcmClockOptions options{.is_realtime = pace == "realtime"};
      if (giveup_s > 0) options.giveup_s = giveup_s;
      RunLockstep(arguments, files.roster, name, factory, options);
    }
    return 0;
  });
}

}  // namespace cell
