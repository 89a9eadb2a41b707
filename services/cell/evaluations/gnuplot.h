#pragma once

#include <string>

namespace cell::cli {

/// Lets gnuplot run `program`. Returns what is wrong, or nothing: that gnuplot
/// is not installed is no failure of an evaluation whose numbers are written.
std::string RunGnuplot(const std::string& program);

}  // namespace cell::cli
