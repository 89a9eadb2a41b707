#pragma once

#include <filesystem>
#include <vector>

#include "common/recordings/recording.h"

namespace cell {

/// The folder of a task that holds the recordings it is taught from.
inline constexpr char kRecordingsFolder[] = "recordings";

inline constexpr char kRecordingExtension[] = ".recording";

/// The recordings in a folder, by name; none if there is no folder.
std::vector<std::filesystem::path> RecordingsIn(
    const std::filesystem::path& folder);

/// Reads a recording from its file. Storage adapter.
/// @throws RecordingError "file:line: message", or naming the file if it
/// cannot be read or is larger than 64 MiB.
Recording LoadRecording(const std::filesystem::path& path);

}  // namespace cell
