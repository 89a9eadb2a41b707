// The units of an installed cell are the services of its roster.
#include "services/cell/running/service_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "common/node/cell_files.h"

namespace cell::cli {
namespace {

std::set<std::string> WantedBy(const std::string& target) {
  std::ifstream file(std::string(CELL_BIN_DIR) + "/../deploy/systemd/user/" +
                     target);
  std::set<std::string> units;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("Wants=")) continue;
    std::istringstream names(line.substr(line.find('=') + 1));
    for (std::string name; names >> name;) units.insert(name);
  }
  units.erase("cell-bus.service");
  units.erase("cell-session.service");
  return units;
}

std::string UnitOf(std::string service) {
  std::ranges::replace(service, '_', '-');
  return "cell-" + service + ".service";
}

TEST(Units, AreThoseOfTheRoster) {
  const CellFiles files =
      FindCellFiles(std::string(CELL_SOURCE_DIR) + "/deploy");
  std::set<std::string> always, cameras;
  const Config roster = files.deployment.ForService("roster");
  for (const Config& entry : roster["services"].Items()) {
    const auto unit = UnitOf(entry.Get<std::string>("name"));
    (entry.Has("option") ? cameras : always).insert(unit);
  }
  EXPECT_EQ(WantedBy("cell.target"), always);
  EXPECT_EQ(WantedBy("cell-cameras.target"), cameras);
}

}  // namespace
}  // namespace cell::cli
