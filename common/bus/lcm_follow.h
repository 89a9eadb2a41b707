#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "common/bus/clock_host.h"
#include "common/bus/lcm_port.h"
#include "common/bus/process_hooks.h"
#include "common/bus/roster.h"

namespace cell {

/// What became of a service that followed a log.
struct FollowSummary {
  int32_t num_ticks = 0;
  int64_t num_equal = 0;  ///< messages as in the log
  std::optional<std::string> difference;
};

/// Lets one service follow a log that lcm-logplayer plays, until its last TICK
/// or until `stop` is set.
/// @throws BusError when the player or the network has lost a message.
FollowSummary RunLcmFollow(const LcmAddress& address, const Roster& roster,
                           const std::string& name,
                           const ServiceFactory& factory,
                           const ProcessHooks& hooks,
                           const std::atomic<bool>& stop);

}  // namespace cell
