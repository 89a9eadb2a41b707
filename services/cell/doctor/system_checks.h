#pragma once

#include <vector>

#include "services/cell/doctor/check.h"

namespace cell::cli {

/// The host: clock, processors, private networks, and the folder in which runs
/// are kept. Pure.
std::vector<Check> SystemChecks();

}  // namespace cell::cli
