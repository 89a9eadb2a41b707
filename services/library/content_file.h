#pragma once

#include <filesystem>

#include "services/library/library_content.h"

namespace cell::library {

/// What a library held, as JSON (content_json.h): exported, or as of the start
/// of a run. Storage adapter.
inline constexpr char kStartContentName[] =
    "library.json";  ///< in a run folder

/// Replaces the file as a whole. @throws std::runtime_error naming it.
void WriteContent(const std::filesystem::path& file,
                  const LibraryContent& content);
/// The same, but never instead of another file.
void ExportContent(const std::filesystem::path& file,
                   const LibraryContent& content);
/// @throws StoreError naming the file and the key in it.
LibraryContent ReadContent(const std::filesystem::path& file);

}  // namespace cell::library
