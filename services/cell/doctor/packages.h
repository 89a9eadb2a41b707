#pragma once

#include <string>
#include <vector>

namespace cell::cli {

/// Packages of a list like scripts/packages.txt that a Debian machine lacks.
struct MissingPackages {
  std::vector<std::string> operating;  ///< of headings "# Operating..."
  std::vector<std::string> others;     ///< for building, testing, looking
};

/// @param status the text of /var/lib/dpkg/status. Pure.
MissingPackages FindMissingPackages(const std::string& list,
                                    const std::string& status);

}  // namespace cell::cli
