#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "common/bus/clock_host.h"
#include "common/config/deployment.h"

namespace cell::cli {

/// Every service of the cell, built from `deployment`; the clock's does the
/// task's script `demonstration` with `seed`. For one run in one process, or
/// one replay of each service: what the library has stored stays with them.
std::map<std::string, ServiceFactory> AllServices(
    const Deployment& deployment, const std::string& demonstration,
    uint64_t seed);

}  // namespace cell::cli
