#pragma once

#include <string>

#include "common/bus/lcm_port.h"

namespace CLI {
class App;
}

namespace cell {

/// The address of a cell's bus on a command line: --url, and --allow-network,
/// without which no process sends to other hosts.
struct AddressOption {
  std::string url = "udpm://239.255.76.67:7667";
  bool may_use_network = false;

  /// This must outlive the parsing.
  void AddTo(CLI::App& app);

  /// @throws std::invalid_argument that names the option: a url that is none,
  /// or that reaches other hosts without --allow-network.
  LcmAddress Get() const;
};

}  // namespace cell
