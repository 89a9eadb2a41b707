#pragma once

#include <string>

namespace cell::cli {

/// The output of a systemctl that failed, and the user who called it.
struct ManagerFailure {
  std::string output;
  int exit_code = 1;
  bool is_user = false;  ///< of the user's own manager
  bool is_root = false;
};

/// What is missing, in plain words, and what to do; systemctl's own words if it
/// is none of what is known here. Pure.
std::string Explain(const ManagerFailure& failure);

}  // namespace cell::cli
