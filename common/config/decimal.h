#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cell {

/// A number, or why a text is none.
template <class T>
struct Decimal {
  std::optional<T> value;
  std::string why;  ///< "has a leading zero", ...
};

/// Reads the whole text as a decimal number, in every locale alike. Refused
/// are what C would read as another number than a person does: a leading zero
/// (octal), 0x, what follows the number, values beyond the type, nan and inf.
/// T is int, int64_t, uint64_t, or double.
template <class T>
Decimal<T> ParseDecimal(std::string_view text);

}  // namespace cell
