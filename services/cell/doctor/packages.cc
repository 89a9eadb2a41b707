#include "services/cell/doctor/packages.h"

#include <set>
#include <sstream>

namespace cell::cli {
namespace {

std::set<std::string> InstalledIn(const std::string& status) {
  std::set<std::string> installed;
  std::istringstream lines(status);
  constexpr std::string_view kPackage = "Package: ";
  std::string package;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kPackage)) package = line.substr(kPackage.size());
    if (line.starts_with("Status: ") && line.ends_with(" installed")) {
      installed.insert(package);
    }
  }
  return installed;
}

}  // namespace

MissingPackages FindMissingPackages(const std::string& list,
                                    const std::string& status) {
  const std::set<std::string> installed = InstalledIn(status);
  MissingPackages missing;
  bool is_operating = false;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      is_operating = line.starts_with("# Operating");
    } else if (!line.empty() && !installed.contains(line)) {
      (is_operating ? missing.operating : missing.others).push_back(line);
    }
  }
  return missing;
}

}  // namespace cell::cli
