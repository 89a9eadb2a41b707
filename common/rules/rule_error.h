#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace cell::rules {

/// A text that cannot be read: "file:line: what is wrong; what is right".
class RuleError : public std::runtime_error {
 public:
  RuleError(const std::string& file, int line, const std::string& message)
      : std::runtime_error(fmt::format("{}:{}: {}", file, line, message)) {}
};

}  // namespace cell::rules
