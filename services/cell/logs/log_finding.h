#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::cli {

/// Something wrong with a log, and where.
struct LogFinding {
  std::string file;     ///< empty: of no one place
  int64_t offset = -1;  ///< [bytes] in the file
  int64_t length = 0;   ///< [bytes]
  int32_t tick = -1;
  std::string channel;
  std::string text;
};

/// The same with one finding for each place, those without one first, in the
/// order of files and places. Many in a row, each right after the other, have
/// one cause: only the first of them is returned. Pure.
std::vector<LogFinding> ByPlace(std::vector<LogFinding> findings);

/// "cell-0001.lcmlog byte 5132 (97 bytes): tick 13: SUM: ..."
std::string ToString(const LogFinding& finding);

}  // namespace cell::cli
