#pragma once

#include <vector>

#include "services/cell/doctor/check.h"

namespace cell::cli {

/// Whether datagrams of the cell arrive at all who should hear them, and at
/// nobody else: loopback, multicast route, TTL, ports, receive buffers. Pure.
std::vector<Check> NetworkChecks();

}  // namespace cell::cli
