#include "services/cell/doctor/software_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <filesystem>

#include "cell/type_texts.h"
#include "common/bus/sim_bus.h"
#include "common/node/cell_files.h"
#include "services/cell/doctor/packages.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/spy_command.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

// How the file that an error begins with can be had as it was shipped.
std::string Restore(const Site& site, const std::string& error) {
  const std::string file = error.substr(0, error.find(':'));
  const fs::path relative = fs::path(file).lexically_relative(site.deploy_dir);
  if (relative.empty() || *relative.begin() == "..") {
    return "correct it, or name another folder with --deploy";
  }
  if (site.deploy_dir == site.shipped_dir) {
    return fmt::format("git -C {} checkout -- {}", site.deploy_dir,
                       relative.string());
  }
  return fmt::format("cp {} {}", (site.shipped_dir / relative).string(), file);
}

Diagnosis CheckRoster(const Machine&, const Site& site) {
  try {
    const CellFiles files = FindCellFiles(site.deploy_dir);
    return Diagnosis::Ok(fmt::format("{} services work on the task {}",
                                     files.roster.entries.size(),
                                     files.roster.task));
  } catch (const std::exception& e) {
    return Diagnosis::Bad(e.what(), Restore(site, e.what()));
  }
}

// Every service is built from its files and lives for a tick.
Diagnosis CheckConfiguration(const Machine&, const Site& site) {
  CellFiles files;
  try {
    files = FindCellFiles(site.deploy_dir);
  } catch (const std::exception&) {
    return Diagnosis::Ok("(see roster)");
  }
  try {
    CheckTask(files, "");
    SimBus bus(files.roster, AllServices(files.deployment, "", 1));
    bus.Step();
    return Diagnosis::Ok("every service can be built from it");
  } catch (const std::exception& e) {
    return Diagnosis::Bad(e.what(), Restore(site, e.what()));
  }
}

Diagnosis CheckPrograms(const Machine& machine, const Site& site) {
  CellFiles files;
  try {
    files = FindCellFiles(site.deploy_dir);
  } catch (const std::exception&) {
    return Diagnosis::Ok("(see roster)");
  }
  std::vector<std::string> missing, locked;
  for (const Roster::Entry& entry : files.roster.entries) {
    const std::string path =
        site.program_dir + "/" + ServiceName::Parse(entry.name).program;
    const auto status = machine.StatusOf(path);
    auto& list = status ? locked : missing;
    const bool is_bad = !status || (status->mode & 0111) == 0;
    if (is_bad && (list.empty() || list.back() != path)) list.push_back(path);
  }
  if (!missing.empty()) {
    return Diagnosis::Bad(fmt::format("missing: {}", fmt::join(missing, ", ")),
                          "scripts/build");
  }
  if (!locked.empty()) {
    return Diagnosis::Bad(
        fmt::format("cannot be executed: {}", fmt::join(locked, ", ")),
        fmt::format("chmod +x {}", fmt::join(locked, " ")));
  }
  return Diagnosis::Ok("every service has one in " + site.program_dir);
}

// Files of `folder` that are not as the programs were built with.
std::vector<std::string> OddTypesIn(const Machine& machine,
                                    const std::string& folder) {
  std::vector<std::string> odd;
  for (const auto& [name, text] : kTypeTexts) {
    const auto found = machine.Read(fmt::format("{}/{}", folder, name));
    if (!found || *found != text) odd.emplace_back(name);
  }
  return odd;
}

// Run folders keep a copy of these texts: they must be what programs speak.
Diagnosis CheckTypes(const Machine& machine, const Site& site) {
  std::string folder;
  try {
    folder = FindCellFiles(site.deploy_dir).deployment.types_dir.string();
  } catch (const std::exception&) {
    return Diagnosis::Ok("(see roster)");
  }
  const std::vector<std::string> odd = OddTypesIn(machine, folder);
  if (odd.empty()) {
    return Diagnosis::Ok(fmt::format("{} texts are those of the programs",
                                     std::size(kTypeTexts)));
  }
  return Diagnosis::Bad(
      fmt::format("the programs were built with other texts than those in {}: "
                  "{}. Build anew; to have the old texts back, beside these:",
                  folder, fmt::join(odd, ", ")),
      fmt::format("mv {0} {0}.other && {1}/cell types --out {0}", folder,
                  site.program_dir));
}

Diagnosis CheckTypesOfRun(const Machine& machine, const Site& site) {
  if (site.run_dir.empty()) return Diagnosis::Ok("none is asked for (--run)");
  const std::vector<std::string> odd =
      OddTypesIn(machine, site.run_dir + "/lcmtypes");
  if (odd.empty()) return Diagnosis::Ok(site.run_dir + " has this build's");
  return Diagnosis::Bad(
      fmt::format("{} was recorded with other texts than this build's: {}",
                  site.run_dir, fmt::join(odd, ", ")),
      "replay it with a build of the tree that it was recorded with");
}

Diagnosis CheckPackages(const Machine& machine, const Site& site) {
  const fs::path top = fs::path(site.shipped_dir).parent_path();
  const auto list = machine.Read((top / "scripts/packages.txt").string());
  if (site.shipped_dir.empty() || !list)
    return Diagnosis::Ok("installed: dpkg has seen to them");
  const MissingPackages missing = FindMissingPackages(
      *list, machine.Read(site.root + "/var/lib/dpkg/status").value_or(""));
  const auto fix = [&](const std::vector<std::string>& packages) {
    return fmt::format(
        "{}apt-get install -y --no-install-recommends {}",
        site.root.empty() ? "" : fmt::format("chroot {} ", site.root),
        fmt::join(packages, " "));
  };
  if (!missing.operating.empty()) {
    return Diagnosis::Bad(fmt::format("missing for operating a cell: {}",
                                      fmt::join(missing.operating, ", ")),
                          fix(missing.operating));
  }
  if (!missing.others.empty()) {
    return Diagnosis::Warning(
        fmt::format("missing for building, testing or looking: {}",
                    fmt::join(missing.others, ", ")),
        fix(missing.others));
  }
  return Diagnosis::Ok("all are there");
}

Diagnosis CheckSpy(const Machine& machine, const Site& site) {
  const SpyParts parts = FindSpyParts(machine, site.root, site.program_dir);
  if (parts.missing.empty()) return Diagnosis::Ok("cell spy has all it needs");
  std::string what, fix;
  for (const auto& missing : parts.missing) {
    what += (what.empty() ? "no cell spy: " : ", ") + missing.what;
    fix += (fix.empty() ? "" : " && ") + missing.fix;
  }
  return Diagnosis::Warning(what, fix);
}

}  // namespace

std::vector<Check> SoftwareChecks() {
  return {{"roster", CheckRoster},
          {"configuration", CheckConfiguration},
          {"programs", CheckPrograms},
          {"message types", CheckTypes},
          {"types of the run", CheckTypesOfRun},
          {"packages", CheckPackages},
          {"lcm-spy", CheckSpy}};
}

}  // namespace cell::cli
