#pragma once

#include <filesystem>
#include <string>

#include "common/bus/lcm_port.h"
#include "common/bus/process_hooks.h"

namespace CLI {
class App;
}

namespace cell {

/// What every process of a cell is told on its command line.
struct ServiceArguments {
  std::string url = "udpm://239.255.76.67:7667";
  bool may_use_network = false;
  std::string deploy_dir;
  std::string run_dir;
  bool is_live = false;
  std::string state_dir;  ///< of a live cell

  void AddTo(CLI::App& app);

  /// @throws std::invalid_argument that names the option: a url that is none,
  /// or that speaks to the network although nobody has allowed it.
  LcmAddress Address() const;

  /// @throws std::invalid_argument if nothing names it, neither the option nor
  /// systemd ($STATE_DIRECTORY).
  std::filesystem::path StateDir() const;
};

}  // namespace cell
