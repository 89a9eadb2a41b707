#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/node/cell_files.h"

namespace cell::cli {

/// Simulated demonstrations that evaluations share: each is simulated once, and
/// kept as SCRIPT-SEED.recording.
struct DemonstrationSet {
  std::filesystem::path folder;
  std::vector<std::string> scripts;  ///< of demonstrators.yaml, taken in turn
  int num = 0;
  uint64_t seed = 1;  ///< of the first; the next has the next
  int num_processes = 1;
};

/// The files of the set, in the order of their seeds; those that are missing
/// are simulated, which shows progress.
/// @throws std::runtime_error if one cannot be made, or a signal stops it.
std::vector<std::filesystem::path> MakeDemonstrations(
    const DemonstrationSet& set, const CellFiles& files);

}  // namespace cell::cli
