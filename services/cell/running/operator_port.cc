#include "services/cell/running/operator_port.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/node/number_option.h"

namespace cell::cli {
namespace {

// The cell's time now, from what is said in every tick: TICK in lockstep,
// MOTION_PERMIT in a live cell.
int64_t AwaitTick(const std::string& url) {
  LcmPort port(url);
  std::optional<int64_t> utime;
  port.Subscribe("(TICK|MOTION_PERMIT)", [&](const std::string&, Bytes bytes) {
    if (bytes.size() >= kWireHeaderEnd) utime = ReadWireHeader(bytes).utime;
  });
  constexpr int kPatienceMs = 2000;
  constexpr int kStepMs = 20;
  for (int waited = 0; waited < kPatienceMs && !utime; waited += kStepMs) {
    WaitForAny({&port}, kStepMs);
    port.Drain();
  }
  if (!utime) {
    throw std::runtime_error(
        "neither TICK nor MOTION_PERMIT heard in 2 s: does the cell run "
        "(cell status), and on this --url?");
  }
  return *utime;
}

}  // namespace

void AddOperatorOptions(CLI::App& command, OperatorOptions* options) {
  options->address.AddTo(command);
  command
      .add_option("--deadline", options->deadline_s,
                  "not executed later than so many seconds of the cell's time")
      ->check(NumberIn(0., 3600.))
      ->capture_default_str();
}

OperatorPort::OperatorPort(const OperatorOptions& options)
    : control_(options.address.Get().ControlUrl()),
      utime_(AwaitTick(options.address.Get().MainUrl())),
      deadline_utime_(utime_ + std::llround(options.deadline_s * 1e6)) {}

}  // namespace cell::cli
