#pragma once

#include <filesystem>
#include <vector>

#include "services/library/action_record.h"

namespace cell {

/// What a library held, as JSON (record_json.h): exported, or as of the start
/// of a run. Storage adapter.
inline constexpr char kStartContentName[] =
    "library.json";  ///< in a run folder

/// Replaces the file as a whole. @throws StoreError naming it.
void WriteContent(const std::filesystem::path& file,
                  const std::vector<ActionRecord>& records);
/// @throws StoreError naming the file and the key in it.
std::vector<ActionRecord> ReadContent(const std::filesystem::path& file);

}  // namespace cell
