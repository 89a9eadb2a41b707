#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace cell {

/// A scene has at most so many unmodelled segments: things that a tracker sees,
/// and that the task has no model of.
inline constexpr size_t kMaxSegments = 32;

/// How the cell calls the segment that a tracker calls `id`: "segment 7" of "7"
/// or "segment 7". Nullopt unless `id` is 1 to 40 letters, digits and any of
/// "_.@+-".
std::optional<std::string> SegmentName(const std::string& id);

/// True of what SegmentName() returns. No object of a scene has such a name.
bool IsSegmentName(const std::string& name);

}  // namespace cell
