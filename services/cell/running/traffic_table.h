#pragma once

#include <string>

#include "services/cell/running/traffic.h"

namespace cell::cli {

/// The report as text, a line for each service and each channel. A screen of
/// fewer `columns` than the tables need gets each name on a line of its own and
/// the numbers, named, below it. If no cell is heard it says that instead.
std::string TrafficTable(const Traffic::Report& report, int columns);

}  // namespace cell::cli
