#pragma once

#include <filesystem>
#include <string>

#include "common/bus/roster.h"
#include "common/config/deployment.h"

namespace cell {

/// The files of a cell and the list of its services.
struct CellFiles {
  Deployment deployment;
  Roster roster;
};

/// Reads them from `deploy_dir` (with config/ and tasks/) if it is not empty,
/// else from the folder deploy beside or above the program (a build tree), else
/// from where the cell was installed.
/// @throws std::runtime_error that names where it looked, ConfigError for a
/// roster that cannot be used.
CellFiles FindCellFiles(const std::string& deploy_dir);

/// Those of the cell that was installed, which its units run by, whichever
/// program asks. @throws like FindCellFiles().
CellFiles FindInstalledCellFiles();

/// Where the programs of the services are: beside this program (a build tree)
/// or where the cell was installed.
std::filesystem::path FolderOfPrograms();

/// Where an installed cell has config/ and the environment of its units.
std::filesystem::path InstalledConfigDir();

/// Where an installed cell has its tasks, its message types and their jar.
std::filesystem::path InstalledDataDir();

/// "robot_arm" and "left" of "robot_arm@left"; no instance: empty.
struct ServiceName {
  std::string program;
  std::string instance;
  static ServiceName Parse(const std::string& name);
};

}  // namespace cell
