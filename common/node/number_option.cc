#include "common/node/number_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <type_traits>

#include "common/config/decimal.h"

namespace cell {
namespace {

template <class T>
std::string RangeText(T low, T high) {
  const bool has_low = low > std::numeric_limits<T>::lowest();
  const bool has_high = high < std::numeric_limits<T>::max();
  if (has_high || std::is_integral_v<T>)
    return fmt::format(" from {} to {}", low, high);
  if (has_low) return fmt::format(", {} or more", low);
  return "";
}

}  // namespace

template <class T>
CLI::Validator NumberIn(T low, T high) {
  const auto check = [low, high](std::string& text) -> std::string {
    const Result<T> number = ParseDecimal<T>(text);
    const bool is_inside = number && *number >= low && *number <= high;
    if (is_inside) return "";
    return fmt::format("'{}' {}; should be a {}number{}", text,
                       number ? "is out of range" : number.reason(),
                       std::is_integral_v<T> ? "whole " : "",
                       RangeText(low, high));
  };
  return CLI::Validator(check, RangeText(low, high));
}

template CLI::Validator NumberIn(int, int);
template CLI::Validator NumberIn(int64_t, int64_t);
template CLI::Validator NumberIn(uint64_t, uint64_t);
template CLI::Validator NumberIn(double, double);

}  // namespace cell
