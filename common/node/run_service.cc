#include "common/node/run_service.h"

#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/bus/lcm_follow.h"
#include "common/bus/lcm_live.h"
#include "common/bus/lcm_node.h"
#include "common/node/cell_files.h"
#include "common/node/service_arguments.h"
#include "common/node/service_manager.h"
#include "common/text/printable.h"

namespace cell {
namespace {

std::atomic<bool> g_stop = false;
static_assert(std::atomic<bool>::is_always_lock_free);

int Follow(const ServiceArguments& arguments, const Roster& roster,
           const std::string& name, const ServiceFactory& factory) {
  const FollowSummary summary =
      RunLcmFollow(arguments.address.Get(), roster, name, factory,
                   ReportToServiceManager(), StopOnSignals());
  std::cerr << fmt::format(
      "{}: followed {} ticks, {} messages identical to the log\n", name,
      summary.num_ticks, summary.num_equal);
  if (!summary.difference) return 0;
  std::cerr << name << ": " << Printable(*summary.difference) << std::endl;
  return 1;
}

int Run(const std::string& program, bool has_instances, int argc, char** argv,
        const InstanceMaker& maker,
        const std::function<void(CLI::App&)>& add_options) {
  const std::string of_which = has_instances ? " --instance left" : "";
  CLI::App app("Runs the cell's service " + program +
               " over LCM, in lockstep with the cell's clock, live, or behind "
               "a log.\nExample: " +
               program + of_which + " --url udpm://239.255.76.67:7667");
  ServiceArguments arguments;
  arguments.AddTo(app);
  bool is_follower = false;
  app.add_flag("--follow", is_follower,
               "behind a log of a lockstep run that lcm-logplayer plays")
      ->excludes("--live");
  std::string instance;
  if (has_instances) {
    app.add_option("--instance", instance, "which instance, as in the roster")
        ->required();
  }
  if (add_options) add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  const std::string name = has_instances ? program + "@" + instance : program;
  return ReportFailures(name, [&] {
    CellFiles files = FindCellFiles(arguments.deploy_dir);
    files.deployment.run_dir = arguments.run_dir;
    files.deployment.is_live = arguments.is_live;
    const ServiceFactory factory = [&](Bus& bus) {
      auto service = maker(bus, files.deployment, instance);
      malloc_trim(0);  // what reading the task's files took
      return service;
    };
    if (is_follower) return Follow(arguments, files.roster, name, factory);
    if (arguments.is_live) {
      RunLcmLive(arguments.address.Get(), files.roster, name, factory,
                 arguments.StateDir(), ReportToServiceManager(),
                 StopOnSignals());
    } else {
      RunLcmNode(arguments.address.Get(), files.roster, name, factory,
                 ReportToServiceManager(), StopOnSignals());
    }
    return 0;
  });
}

}  // namespace

const std::atomic<bool>& StopOnSignals() {
  std::signal(SIGINT, [](int) { g_stop = true; });
  std::signal(SIGTERM, [](int) { g_stop = true; });
  return g_stop;
}

int ReportFailures(const std::string& name, const std::function<int()>& run) {
  const auto report = [&](const std::exception& e, int exit_code) {
    const std::string reason = PrintableLines(e.what());
    std::cerr << name << ": " << reason << std::endl;
    ReportReasonToServiceManager(reason);
    return exit_code;
  };
  try {
    return run();
  } catch (const std::invalid_argument& e) {
    return report(e, kExitUsage);
  } catch (const ConfigError& e) {
    return report(e, kExitUsage);
  } catch (const std::exception& e) {
    return report(e, 1);
  }
}

int RunService(const std::string& name, int argc, char** argv,
               const ServiceMaker& maker,
               const std::function<void(CLI::App&)>& add_options) {
  return Run(
      name, false, argc, argv,
      [&](Bus& bus, const Deployment& deployment, const std::string&) {
        return maker(bus, deployment);
      },
      add_options);
}

int RunInstance(const std::string& name, int argc, char** argv,
                const InstanceMaker& maker) {
  return Run(name, true, argc, argv, maker, {});
}

}  // namespace cell
