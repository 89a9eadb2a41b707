#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "common/bus/bus.h"
#include "common/bus/lcm_clock.h"
#include "common/bus/roster.h"
#include "common/config/deployment.h"

namespace CLI {
class App;
}

namespace cell {

/// Builds a service from its files.
using ServiceMaker =
    std::function<std::unique_ptr<Service>(Bus&, const Deployment&)>;

/// The same of a service that a cell has several of: "robot_arm@left" is the
/// instance "left" of robot_arm.
using InstanceMaker = std::function<std::unique_ptr<Service>(
    Bus&, const Deployment&, const std::string& instance)>;

/// The whole of a service's main(): arguments (--help lists them), roster and
/// configuration, the bus in lockstep over LCM, until the clock's last tick or
/// SIGINT or SIGTERM. `add_options` adds what this service alone may be told.
/// @return 0 stopped, 1 failure, 2 usage.
int RunService(const std::string& name, int argc, char** argv,
               const ServiceMaker& maker,
               const std::function<void(CLI::App&)>& add_options = {});
/// Takes the instance from --instance.
int RunInstance(const std::string& name, int argc, char** argv,
                const InstanceMaker& maker);

/// "robot_arm" and "left" of "robot_arm@left"; no instance: empty.
struct ServiceName {
  std::string program;
  std::string instance;
  static ServiceName Parse(const std::string& name);
};

/// The files of a cell and who takes part in it.
struct CellFiles {
  Deployment deployment;
  Roster roster;
};

/// Reads them from `deploy_dir` if it is not empty, else from the folder deploy
/// beside or above the program. @throws std::runtime_error that names where it
/// looked, ConfigError for a roster that cannot be used.
CellFiles FindCellFiles(const std::string& deploy_dir);

/// Set by SIGINT and SIGTERM once the handlers are installed.
const std::atomic<bool>& StopOnSignals();

}  // namespace cell
