#pragma once

#include <cstdint>
#include <string>

#include "common/bus/bus.h"
#include "common/bus/lcm_port.h"
#include "common/node/address_option.h"

namespace CLI {
class App;
}

namespace cell::cli {

/// How an operator's word reaches the clock, and until when it counts.
struct OperatorOptions {
  AddressOption address;
  double deadline_s = 1;
};

/// Adds --url, --allow-network and --deadline. `options` must outlive the
/// parsing.
void AddOperatorOptions(CLI::App& command, OperatorOptions* options);

/// A connection to the clock of a cell that runs.
class OperatorPort {
 public:
  /// Waits for the cell to say what time it is. @throws std::runtime_error if
  /// it is silent.
  explicit OperatorPort(const OperatorOptions& options);

  /// [us] of the cell's time, after which the command is not executed.
  int64_t deadline_utime() const { return deadline_utime_; }

  /// Fills in header.utime and the deadline.
  template <class Command>
  void Send(const std::string& channel, Command command) {
    command.header.utime = utime_;
    command.deadline_utime = deadline_utime_;
    control_.Publish(channel, Bus::Encode(command));
  }

 private:
  LcmPort control_;
  int64_t utime_;
  int64_t deadline_utime_;
};

}  // namespace cell::cli
