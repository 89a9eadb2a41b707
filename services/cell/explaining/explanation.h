#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::cli {

/// A line each, without indentation.
using Reasons = std::vector<std::string>;

inline void Append(const Reasons& more, Reasons* reasons) {
  reasons->insert(reasons->end(), more.begin(), more.end());
}

/// Why the cell did or said something at a moment, in plain English.
struct Explanation {
  int64_t utime = 0;  ///< [us] of what is explained
  std::string what;   ///< one line
  Reasons reasons = {};
};

}  // namespace cell::cli
