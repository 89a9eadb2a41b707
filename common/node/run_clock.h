#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/bus/bus.h"
#include "common/config/deployment.h"

namespace cell {

/// Builds the service that owns time: `demonstration` names a script of the
/// task ("": the configured one), `seed` is where all its chance comes from.
using ClockServiceMaker = std::function<std::unique_ptr<Service>(
    Bus&, const Deployment&, const std::string& demonstration, uint64_t seed)>;

/// The whole of main() for the service that owns time, like RunService().
/// @return 0 the run has ended or was stopped, 1 failure, 2 usage.
int RunClock(const std::string& name, int argc, char** argv,
             const ClockServiceMaker& maker);

}  // namespace cell
