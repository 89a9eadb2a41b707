#pragma once

#include <string_view>

#include "common/result/result.h"

namespace cell {

/// Reads the whole text as a decimal number, in any locale. Refuses what C
/// reads as another number than a person does: a leading zero (octal), 0x, text
/// after the number, values beyond the type, nan and inf. The reason is given
/// as "has a leading zero". T is int, int64_t, uint64_t, or double.
template <class T>
Result<T> ParseDecimal(std::string_view text);

}  // namespace cell
