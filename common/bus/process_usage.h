#pragma once

#include <cstdint>

namespace cell {

struct ProcessUsage {
  int64_t cpu_us = 0;  ///< processor time since the start
  int64_t resident_bytes = 0;
};

/// As the kernel counts it.
ProcessUsage UsageOfThisProcess();

}  // namespace cell
