#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/recordings/recording.h"

namespace cell {

/// The recording that the text holds. `name` stands for the file in errors.
/// @throws RecordingError naming the line, and what would be right.
Recording RecordingFromText(std::string_view text, const std::string& name);

/// The text of a recording. With `decimals`, positions are rounded to so many
/// decimal places [m] and quaternions to as many, but at least five; without,
/// every number is written so that it is read as the same double.
/// @throws std::invalid_argument if times do not rise, a frame does not have
/// one entry per body, or a name has a space.
std::string RecordingToText(const Recording& recording,
                            std::optional<int> decimals);

}  // namespace cell
