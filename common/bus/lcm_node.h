#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "common/bus/clock_host.h"
#include "common/bus/lcm_port.h"
#include "common/bus/process_hooks.h"
#include "common/bus/roster.h"

namespace cell {

/// Runs one service over LCM in lockstep until the clock's last tick or until
/// `stop` is set.
/// @throws BusError when a message is lost or corrupt, or when another cell or
/// another incarnation of the service is heard.
void RunLcmNode(const LcmAddress& address, const Roster& roster,
                const std::string& name, const ServiceFactory& factory,
                const ProcessHooks& hooks, const std::atomic<bool>& stop);

}  // namespace cell
