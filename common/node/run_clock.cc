#include "common/node/run_clock.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "common/bus/lcm_clock.h"
#include "common/node/run_service.h"

namespace cell {

int RunClock(const std::string& name, int argc, char** argv,
             const ClockServiceMaker& maker) {
  CLI::App app("Runs the cell's clock and world, " + name +
               ", in lockstep over LCM.\nExample: " + name +
               " --seed 7 --pace realtime");
  std::string url = "udpm://239.255.76.67:7667";
  std::string deploy_dir;
  std::string run_dir;
  std::string demonstration;
  uint64_t seed = 1;
  std::string pace = "fast";
  double giveup_s = 0;
  app.add_option("--url", url, "LCM address of the cell; control port: +1")
      ->capture_default_str();
  app.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  app.add_option("--run-dir", run_dir, "folder in which the run is recorded");
  app.add_option("--demonstration", demonstration, "script of the task");
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--pace", pace, "as fast as the machine allows, or realtime")
      ->check(CLI::IsMember({"fast", "realtime"}))
      ->capture_default_str();
  app.add_option("--giveup", giveup_s,
                 "end when a service is silent so long [s]; 0: wait for ever");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  try {
    CellFiles files = FindCellFiles(deploy_dir);
    files.deployment.run_dir = run_dir;
    LcmClockOptions options{.is_realtime = pace == "realtime"};
    if (giveup_s > 0) options.giveup_s = giveup_s;
    const LcmClockSummary summary = RunLcmClock(
        LcmAddress::Parse(url), files.roster,
        [&](Bus& bus) {
          return maker(bus, files.deployment, demonstration, seed);
        },
        options, StopOnSignals());
    std::cerr << fmt::format(
        "{}: {} ticks in {:.3f} s, {} TICKs repeated, {} late, {} refused\n",
        name, summary.num_ticks, summary.elapsed_s, summary.num_repeats,
        summary.num_late_ticks, summary.num_refused);
    return 0;
  } catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 1;
  }
}

}  // namespace cell
