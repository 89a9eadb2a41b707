#pragma once

#include <vector>

#include "services/cell/doctor/check.h"

namespace cell::cli {

/// Checks that datagrams of the cell reach all its processes, and no others:
/// loopback, multicast route, TTL, ports, receive buffers. Pure.
std::vector<Check> NetworkChecks();

}  // namespace cell::cli
