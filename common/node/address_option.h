#pragma once

#include <string>

#include "common/bus/lcm_port.h"

namespace CLI {
class App;
}

namespace cell {

/// Where a cell talks, as a command line names it: --url, and --allow-network
/// without which nobody speaks to other hosts.
struct AddressOption {
  std::string url = "udpm://239.255.76.67:7667";
  bool may_use_network = false;

  /// This must outlive the parsing.
  void AddTo(CLI::App& app);

  /// @throws std::invalid_argument that names the option: a url that is none,
  /// or that speaks to the network although nobody has allowed it.
  LcmAddress Get() const;
};

}  // namespace cell
