#include "common/node/cell_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "common/node/install_paths.h"

namespace cell {
namespace {

namespace fs = std::filesystem;

fs::path FolderOfThisProgram() {
  return fs::read_symlink("/proc/self/exe").parent_path();
}

/// A place where a deployment may be; its tasks are folders below `tasks`.
struct Place {
  fs::path config;
  fs::path tasks;
  fs::path types;
};

Place InstalledPlace() {
  return {fs::path(kInstalledConfigDir) / "config",
          fs::path(kInstalledDataDir) / "tasks",
          fs::path(kInstalledDataDir) / "lcmtypes"};
}

std::vector<Place> PlacesFor(const std::string& deploy_dir) {
  const auto in_folder = [](const fs::path& deploy) {
    return Place{deploy / "config", deploy / "tasks",
                 deploy.parent_path() / "lcmtypes"};
  };
  // The folder may be given with a slash at its end.
  if (!deploy_dir.empty()) {
    return {in_folder((fs::absolute(deploy_dir) / "").parent_path())};
  }
  std::vector<Place> places;
  fs::path folder = FolderOfThisProgram();
  for (; folder != folder.root_path(); folder = folder.parent_path()) {
    places.push_back(in_folder(folder / "deploy"));
  }
  places.push_back(InstalledPlace());
  return places;
}

/// Nothing if there is no deployment.
std::optional<CellFiles> FilesAt(const Place& place) {
  const fs::path file = place.config / "roster.yaml";
  if (!fs::is_regular_file(file)) return std::nullopt;
  const Roster roster = Roster::FromConfig(Config::Load(file));
  const Deployment deployment{.config_dir = place.config,
                              .task_dir = place.tasks / roster.task,
                              .types_dir = place.types};
  if (fs::is_directory(deployment.task_dir)) return {{deployment, roster}};
  throw std::runtime_error(file.string() + ":task: there is no folder " +
                           deployment.task_dir.string());
}

}  // namespace

CellFiles FindCellFiles(const std::string& deploy_dir) {
  const std::vector<Place> places = PlacesFor(deploy_dir);
  for (const Place& place : places) {
    if (auto files = FilesAt(place)) return *std::move(files);
  }
  throw std::runtime_error(fmt::format(
      "no deployment: there is no {} (nor in the folders above); name a folder "
      "that has config/ and tasks/ with --deploy DIR",
      (places.front().config / "roster.yaml").string()));
}

CellFiles FindInstalledCellFiles() {
  if (auto files = FilesAt(InstalledPlace())) return *std::move(files);
  throw std::runtime_error(
      fmt::format("the cell is not installed (there is no {}): cmake --install "
                  "build/release",
                  (InstalledPlace().config / "roster.yaml").string()));
}

fs::path FolderOfPrograms() {
  const fs::path beside = FolderOfThisProgram();
  const fs::path installed = kInstalledProgramDir;
  // The command line is installed apart from the services.
  return fs::exists(beside / "recorder") || !fs::exists(installed) ? beside
                                                                   : installed;
}

fs::path InstalledConfigDir() {
  return kInstalledConfigDir;
}

fs::path InstalledDataDir() {
  return kInstalledDataDir;
}

ServiceName ServiceName::Parse(const std::string& name) {
  const size_t at = name.find('@');
  if (at == std::string::npos) return {name, ""};
  return {name.substr(0, at), name.substr(at + 1)};
}

}  // namespace cell
