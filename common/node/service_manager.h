#pragma once

#include <string>

#include "common/bus/process_hooks.h"

namespace cell {

/// Tells systemd, if it has started this process, that it is ready, and as
/// often as the unit's WatchdogSec wants that it is alive.
ProcessHooks ReportToServiceManager();

/// Tells systemd, if it has started this process, why it ends.
void ReportReasonToServiceManager(const std::string& reason);

}  // namespace cell
