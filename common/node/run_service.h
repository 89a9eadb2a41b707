#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "common/bus/bus.h"
#include "common/config/deployment.h"

namespace CLI {
class App;
}

namespace cell {

/// The exit code for wrong arguments or files: starting the process again does
/// not help.
inline constexpr int kExitUsage = 2;

/// Builds a service from its files.
using ServiceMaker =
    std::function<std::unique_ptr<Service>(Bus&, const Deployment&)>;

/// The same of a service that a cell has several of: "robot_arm@left" is the
/// instance "left" of robot_arm.
using InstanceMaker = std::function<std::unique_ptr<Service>(
    Bus&, const Deployment&, const std::string& instance)>;

/// The whole of a service's main(): arguments (--help lists them), roster and
/// configuration; then the bus over LCM: in lockstep until the clock's last
/// tick, live (--live), or behind a log that is played (--follow); until SIGINT
/// or SIGTERM.
/// `add_options` adds the options of this service alone.
/// @return 0 stopped, 1 failure, 2 usage.
int RunService(const std::string& name, int argc, char** argv,
               const ServiceMaker& maker,
               const std::function<void(CLI::App&)>& add_options = {});
/// Takes the instance from --instance.
int RunInstance(const std::string& name, int argc, char** argv,
                const InstanceMaker& maker);

/// Runs `run` and returns its exit code. Reports an exception on stderr, after
/// `name`: kExitUsage for a wrong argument or configuration, 1 for others.
int ReportFailures(const std::string& name, const std::function<int()>& run);

/// Set by SIGINT and SIGTERM once the handlers are installed.
const std::atomic<bool>& StopOnSignals();

}  // namespace cell
