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
#include "services/cell/doctor/spy_command.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

// How to correct the file that an error begins with. Never a command that
// overwrites it, since the user may have changed it.
std::string Correct(const Site& site, const std::string& error) {
  const std::string file = error.substr(0, error.find(':'));
  const fs::path relative = fs::path(file).lexically_relative(site.deploy_dir);
  std::string fix = "correct it there";
  if (relative.empty() || *relative.begin() == "..") return fix;
  const fs::path shipped = site.shipped_dir / relative;
  if (site.deploy_dir == site.shipped_dir) {
    return fmt::format("{}; git -C {} diff -- {} shows what was changed", fix,
                       site.deploy_dir, relative.string());
  }
  if (site.shipped_dir.empty() || !fs::exists(shipped)) return fix;
  return fmt::format("{}; diff {} {} shows what was changed", fix,
                     shipped.string(), file);
}

Diagnosis CheckRoster(const Machine&, const Site& site) {
  try {
    const CellFiles files = FindCellFiles(site.deploy_dir);
    return Diagnosis::Ok(fmt::format("{} services work on the task {}",
                                     files.roster.entries.size(),
                                     files.roster.task));
  } catch (const std::exception& e) {
    return Diagnosis::Bad(e.what(), Correct(site, e.what()));
  }
}

// Every service is built from its files and runs for one tick.
Diagnosis CheckConfiguration(const Machine&, const Site& site) {
  CellFiles files;
  try {
    files = FindCellFiles(site.deploy_dir);
  } catch (const std::exception&) {
    return Diagnosis::Ok("(see roster)");
  }
  try {
    CheckTask(files, {.has_cameras = !files.roster.absent.empty()});
    SimBus bus(files.roster, AllServices(files.deployment, "", 1));
    bus.Step();
    return Diagnosis::Ok("every service can be built from it");
  } catch (const std::exception& e) {
    return Diagnosis::Bad(e.what(), Correct(site, e.what()));
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

struct TypeTexts {
  std::vector<std::string> missing;
  std::vector<std::string> different;

  bool is_good() const { return missing.empty() && different.empty(); }
  bool are_none() const { return missing.size() == std::size(kTypeTexts); }
  std::string ToString() const;
};

// The first ones; all are counted.
std::string FirstOf(const std::vector<std::string>& names) {
  constexpr size_t kMaxNames = 5;
  const size_t num = std::min(names.size(), kMaxNames);
  const std::string text = fmt::format(
      "{}", fmt::join(names.begin(),
                      names.begin() + static_cast<std::ptrdiff_t>(num), ", "));
  if (num == names.size()) return text;
  return fmt::format("{} and {} more", text, names.size() - num);
}

std::string TypeTexts::ToString() const {
  std::string text;
  if (!different.empty()) text = "different: " + FirstOf(different);
  if (!missing.empty()) {
    text += (text.empty() ? "" : "; ") + ("missing: " + FirstOf(missing));
  }
  return text;
}

// How the texts in `folder` differ from those the programs were built with.
TypeTexts TypeTextsIn(const Machine& machine, const std::string& folder) {
  TypeTexts texts;
  for (const auto& [name, text] : kTypeTexts) {
    const auto found = machine.Read(fmt::format("{}/{}", folder, name));
    if (!found) {
      texts.missing.emplace_back(name);
    } else if (*found != text) {
      texts.different.emplace_back(name);
    }
  }
  return texts;
}

// Run folders keep a copy of these texts: they must be the definitions that the
// programs are built with.
Diagnosis CheckTypes(const Machine& machine, const Site& site) {
  std::string folder;
  try {
    folder = FindCellFiles(site.deploy_dir).deployment.types_dir.string();
  } catch (const std::exception&) {
    return Diagnosis::Ok("(see roster)");
  }
  const TypeTexts texts = TypeTextsIn(machine, folder);
  if (texts.is_good()) {
    return Diagnosis::Ok(
        fmt::format("{} texts agree with the programs", std::size(kTypeTexts)));
  }
  if (texts.are_none()) {
    return Diagnosis::Bad(
        fmt::format("there are no message type texts in {}, beside the "
                    "deployment; runs would lack them",
                    folder),
        fmt::format("{}/cell types --out {}", site.program_dir, folder));
  }
  return Diagnosis::Bad(
      fmt::format(
          "the programs were built with texts other than those in {}: {}. "
          "Rebuild; or restore the programs' texts and keep these beside them:",
          folder, texts.ToString()),
      fmt::format("mv {0} {0}.other && {1}/cell types --out {0}", folder,
                  site.program_dir));
}

Diagnosis CheckTypesOfRun(const Machine& machine, const Site& site) {
  if (site.run_dir.empty()) return Diagnosis::Ok("no run given (--run)");
  const TypeTexts texts = TypeTextsIn(machine, site.run_dir + "/lcmtypes");
  if (texts.is_good())
    return Diagnosis::Ok(site.run_dir + " has the types of this build");
  if (texts.are_none()) {
    return Diagnosis::Bad(
        fmt::format("there are no message type texts in {}/lcmtypes, where a "
                    "run keeps them",
                    site.run_dir),
        "compare the commit that it was recorded with, if you know it");
  }
  return Diagnosis::Bad(
      fmt::format("{} was recorded with texts other than this build's: {}",
                  site.run_dir, texts.ToString()),
      "replay it with a build of the tree that it was recorded with");
}

Diagnosis CheckPackages(const Machine& machine, const Site& site) {
  const fs::path top = fs::path(site.shipped_dir).parent_path();
  const auto list = machine.Read((top / "scripts/packages.txt").string());
  if (site.shipped_dir.empty() || !list)
    return Diagnosis::Ok("installed; dpkg has checked them");
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
        fmt::format("missing for building, testing or viewing: {}",
                    fmt::join(missing.others, ", ")),
        fix(missing.others));
  }
  return Diagnosis::Ok("all are installed");
}

Diagnosis CheckSpy(const Machine& machine, const Site& site) {
  const SpyParts parts = FindSpyParts(machine, site.root, site.program_dir);
  if (parts.missing.empty()) return Diagnosis::Ok("cell spy has all it needs");
  std::string what, fix;
  for (const auto& missing : parts.missing) {
    what += (what.empty() ? "cell spy cannot run: " : ", ") + missing.what;
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
