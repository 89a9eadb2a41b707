#pragma once

#include <stdexcept>

namespace cell::ppddl {

/// A text that is not PPDDL, or uses a feature that is not supported:
/// "domain.pddl:3:14: there is no predicate 'cleer'; did you mean 'clear'?".
class PpddlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cell::ppddl
