#pragma once

#include <filesystem>
#include <vector>

#include "common/actions/action_record.h"

namespace cell::library {

/// What a library held, as JSON (record_json.h): exported, or as of the start
/// of a run. Storage adapter.
inline constexpr char kStartContentName[] =
    "library.json";  ///< in a run folder

/// Replaces the file as a whole. @throws std::runtime_error naming it.
void WriteContent(const std::filesystem::path& file,
                  const std::vector<ActionRecord>& records);
/// The same, but never instead of another file.
void ExportContent(const std::filesystem::path& file,
                   const std::vector<ActionRecord>& records);
/// @throws StoreError naming the file and the key in it.
std::vector<ActionRecord> ReadContent(const std::filesystem::path& file);

}  // namespace cell::library
