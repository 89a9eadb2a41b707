#pragma once

#include <filesystem>
#include <string>

#include "common/bus/process_hooks.h"
#include "common/node/address_option.h"

namespace CLI {
class App;
}

namespace cell {

/// The command line arguments of every process of a cell.
struct ServiceArguments {
  AddressOption address;
  std::string deploy_dir;
  std::string run_dir;
  bool is_live = false;
  std::string state_dir;  ///< of a live cell

  void AddTo(CLI::App& app);

  /// @throws std::invalid_argument if nothing names it, neither the option nor
  /// systemd ($STATE_DIRECTORY).
  std::filesystem::path StateDir() const;
};

}  // namespace cell
