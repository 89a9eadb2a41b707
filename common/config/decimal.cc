#include "common/config/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace cell {
namespace {

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view WithoutSign(std::string_view text) {
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  return text.substr(has_sign ? 1 : 0);
}

template <class T>
std::string WhyNot(std::string_view text, bool is_read, bool is_beyond) {
  const std::string_view digits = WithoutSign(text);
  if (digits.size() > 1 && digits[0] == '0' && IsDigit(digits[1])) {
    return "has a leading zero";
  }
  if (is_beyond) return "is out of range";
  if (std::is_unsigned_v<T> && text.starts_with('-')) return "is negative";
  if (is_read) return "";
  return std::is_integral_v<T> ? "is not a whole number" : "is not a number";
}

}  // namespace

template <class T>
Result<T> ParseDecimal(std::string_view text) {
  // from_chars() knows no plus.
  const std::string_view digits = WithoutSign(text);
  const std::string_view read = text.starts_with('+') ? digits : text;
  T value{};
  const auto [end, error] =
      std::from_chars(read.data(), read.data() + read.size(), value);
  const bool is_whole = end == read.data() + read.size() && !digits.empty() &&
                        digits[0] != '-' && digits[0] != '+';
  const bool is_beyond = is_whole && error == std::errc::result_out_of_range;
  const bool is_read = is_whole && error == std::errc();
  std::string why = WhyNot<T>(text, is_read, is_beyond);
  if constexpr (std::is_floating_point_v<T>) {
    if (is_read && !std::isfinite(value)) why = "is not a finite number";
    if (digits == ".nan" || digits == ".inf") why = "is not a finite number";
  }
  if (!why.empty()) return Reason{why};
  return value;
}

template Result<int> ParseDecimal(std::string_view);
template Result<int64_t> ParseDecimal(std::string_view);
template Result<uint64_t> ParseDecimal(std::string_view);
template Result<double> ParseDecimal(std::string_view);

}  // namespace cell
