#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/bus/clock_host.h"
#include "common/bus/lcm_port.h"
#include "common/bus/process_hooks.h"
#include "common/bus/roster.h"

namespace cell {

/// Runs one service of a live cell over LCM by the wall's (monotonic) clock,
/// until `stop` is set: an activation in each tick of 8 ms, with what has come.
/// A service that is late skips ticks; the one at the roster's head makes them
/// up, unless it is late by more than a second. `state_dir`: of LiveState,
/// shared by the cell. @throws BusError.
void RunLcmLive(const LcmAddress& address, const Roster& roster,
                const std::string& name, const ServiceFactory& factory,
                const std::filesystem::path& state_dir,
                const ProcessHooks& hooks, const std::atomic<bool>& stop);

}  // namespace cell
