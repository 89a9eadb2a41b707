#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::cli {

/// Why the cell did or said something at a moment, in plain English.
struct Explanation {
  int64_t utime = 0;                 ///< [us] of what is explained
  std::string what;                  ///< one line
  std::vector<std::string> reasons;  ///< a line each, without indentation
};

}  // namespace cell::cli
