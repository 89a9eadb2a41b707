#pragma once

#include <string>
#include <variant>

namespace cell::robot_arm {

/// A result, or in plain words why there is none.
template <class T>
using OrReason = std::variant<T, std::string>;

}  // namespace cell::robot_arm
