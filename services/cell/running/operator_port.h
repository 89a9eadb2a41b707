#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cell/answer_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/lcm_port.h"
#include "services/cell/running/cell_address.h"

namespace CLI {
class App;
}

namespace cell::cli {

/// The address for an operator's command, and its deadline.
struct OperatorOptions {
  CellAddress address;
  double deadline_s = 1;
};

/// Adds the options of the address and --deadline. `options` must outlive the
/// parsing.
void AddOperatorOptions(CLI::App& command, OperatorOptions* options);

/// An operator's command, and the service that answers it.
struct OperatorCommand {
  std::string channel;  ///< COMMAND_*
  std::string service;  ///< that takes it
  std::string what;     ///< "hold"
};

/// A connection to the clock of a cell that runs, for one command.
class OperatorPort {
 public:
  /// Waits for the cell's time. @throws std::runtime_error if no message comes.
  OperatorPort(const OperatorOptions& options, OperatorCommand command);

  /// Fills in header.utime and the deadline, sends the command, waits for its
  /// answer and prints it. Returns 0 if the command was accepted, 1 if it was
  /// refused. @throws std::runtime_error, naming the service that should
  /// answer, if there is no answer a few seconds past the deadline.
  template <class Command>
  int Execute(Command command) {
    command.header.utime = *utime_;
    command.deadline_utime = DeadlineUtime();
    return Execute(Bus::Encode(command));
  }

 private:
  OperatorPort(const LcmAddress& address, double deadline_s,
               OperatorCommand command);
  int Execute(const Bytes& bytes);
  int64_t DeadlineUtime() const;
  void OnMessage(const std::string& channel, const Bytes& bytes);
  const answer_t* FindAnswer() const;
  bool IsTooLate() const;
  [[noreturn]] void Fail() const;

  OperatorCommand command_;
  double deadline_s_;
  LcmPort control_;
  LcmPort main_;
  std::optional<int64_t> utime_;  // of the cell, last heard
  int silent_ms_ = 0;             // since it was heard
  Bytes sent_;
  int64_t deadline_utime_ = 0;
  std::optional<WireHeader> passed_on_;  // the command, as the clock sent it
  std::vector<answer_t> answers_;        // on the command's channel
};

}  // namespace cell::cli
