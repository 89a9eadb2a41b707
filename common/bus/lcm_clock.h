#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "common/bus/clock_host.h"
#include "common/bus/lcm_port.h"
#include "common/bus/process_hooks.h"
#include "common/bus/roster.h"

namespace cell {

struct LcmClockOptions {
  bool is_realtime = false;        ///< at most as fast as the wall clock
  std::optional<double> giveup_s;  ///< end when a service is silent so long
};

/// What a run of the clock came to.
struct LcmClockSummary {
  int32_t num_ticks = 0;
  double elapsed_s = 0;        ///< from the first tick on
  int64_t num_repeats = 0;     ///< TICKs sent again
  int64_t num_late_ticks = 0;  ///< of a run in real time
  int64_t num_refused = 0;     ///< HELLOs, ACKs and commands
};

/// Runs the service that owns time over LCM, with all others in lockstep, until
/// it ends the run or `stop` is set.
/// @throws BusError when `giveup_s` has passed, when a message is lost, or when
/// another clock is heard.
LcmClockSummary RunLcmClock(const LcmAddress& address, const Roster& roster,
                            const ServiceFactory& factory,
                            const LcmClockOptions& options,
                            const ProcessHooks& hooks,
                            const std::atomic<bool>& stop);

}  // namespace cell
