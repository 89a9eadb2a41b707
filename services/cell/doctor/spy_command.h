#pragma once

#include <string>
#include <vector>

#include "services/cell/doctor/machine.h"

namespace cell::cli {

/// What lcm-spy needs. Debian's own wrapper fails with Java 17.
struct SpyParts {
  std::string java;       ///< a Java that can open windows
  std::string lcm_jar;    ///< LCM for Java, lcm-spy in it
  std::string chart_jar;  ///< draws its curves
  std::string types_jar;  ///< the cell's message types, made by the build
  /// One line for each that is missing: what, and the command that helps.
  struct Missing {
    std::string what;
    std::string fix;
  };
  std::vector<Missing> missing;
};

/// Looks in the places where Debian puts them, under `root` ("": /), and for
/// the jar of types in deploy/spy beside or above `program_dir`.
SpyParts FindSpyParts(const Machine& machine, const std::string& root,
                      const std::string& program_dir);

/// The command line that starts lcm-spy on `lcm_url`.
/// @pre nothing is missing
std::vector<std::string> SpyCommand(const SpyParts& parts,
                                    const std::string& lcm_url);

}  // namespace cell::cli
