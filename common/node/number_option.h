#pragma once

#include <limits>

namespace CLI {
class Validator;
}

namespace cell {

/// The check of every option that takes a number: the text is a decimal number
/// (ParseDecimal) in [low, high]. The error names option, value and what would
/// be right. T is int, int64_t, uint64_t, or double.
template <class T>
CLI::Validator NumberIn(T low = std::numeric_limits<T>::lowest(),
                        T high = std::numeric_limits<T>::max());

}  // namespace cell
