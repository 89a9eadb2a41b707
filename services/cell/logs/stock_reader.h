#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cell::cli {

/// What LCM's own log reader returns of a file.
struct StockReading {
  int64_t num_events = 0;
  std::string end;  ///< "says that the log ends", "killed by signal 11"
};

/// Reads `log` as they do, in a child process with bounded memory: a
/// damaged log may crash it. Storage adapter.
/// @throws std::system_error if no child can be started.
StockReading ReadAsStockToolsDo(const std::filesystem::path& log);

}  // namespace cell::cli
