#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "services/cell/commands/commands.h"
#include "services/cell/doctor/host_machine.h"
#include "services/cell/doctor/network_checks.h"
#include "services/cell/doctor/software_checks.h"
#include "services/cell/doctor/system_checks.h"

namespace cell::cli {

namespace fs = std::filesystem;

namespace {

struct DoctorOptions {
  Site site;
  std::string root = "/";
  std::string url = "udpm://239.255.76.67:7667";
  int64_t min_free_mb = 2000;
};

// The deploy folder that came with the programs; "" if there is none.
std::string ShippedWith(const fs::path& program_dir) {
  for (fs::path at = program_dir; at.has_relative_path();
       at = at.parent_path()) {
    if (fs::is_directory(at / "deploy" / "config")) {
      return (at / "deploy").string();
    }
  }
  return "";
}

int RunDoctor(const DoctorOptions& options) {
  Site site = options.site;
  const auto program_dir = fs::read_symlink("/proc/self/exe").parent_path();
  if (options.root != "/") site.root = options.root;
  if (site.program_dir.empty()) {
    site.program_dir = FolderOfPrograms().string();
  }
  site.shipped_dir = ShippedWith(program_dir);
  site.deploy_dir = site.deploy_dir.empty()
                        ? site.shipped_dir
                        : fs::absolute(site.deploy_dir).string();
  site.address = LcmAddress::Parse(options.url);
  site.min_free_bytes = options.min_free_mb << 20;

  const HostMachine machine;
  int num_checks = 0, num_bad = 0, num_warnings = 0;
  for (const auto& checks :
       {NetworkChecks(), SystemChecks(), SoftwareChecks()}) {
    for (const Check& check : checks) {
      const Diagnosis diagnosis = check.run(machine, site);
      std::cout << ToString(check.name, diagnosis) << std::endl;
      ++num_checks;
      num_bad += diagnosis.level == Diagnosis::Level::kBad;
      num_warnings += diagnosis.level == Diagnosis::Level::kWarning;
    }
  }
  std::cout << fmt::format("{} checks: {} bad, {} warnings\n", num_checks,
                           num_bad, num_warnings);
  return num_bad == 0 ? 0 : 1;
}

}  // namespace

void AddDoctor(CLI::App& app, Action* action) {
  auto options = std::make_shared<DoctorOptions>();
  CLI::App* command = app.add_subcommand(
      "doctor",
      "Check that a cell can run well on this machine: one line per check, "
      "with the command that fixes a problem. Exit code 1 if anything is bad.\n"
      "Example: cell doctor --runs runs");
  command
      ->add_option("--root", options->root,
                   "examine the system files below this folder")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command->add_option("--deploy", options->site.deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option(
      "--programs", options->site.program_dir,
      "folder of the service programs (default: the folder of cell)");
  command
      ->add_option("--run", options->site.run_dir,
                   "check that the message types of this run are this build's")
      ->check(CLI::ExistingDirectory);
  options->site.runs_dir = "runs";
  command
      ->add_option("--runs", options->site.runs_dir,
                   "folder in which runs are kept")
      ->capture_default_str();
  command->add_option("--url", options->url)->capture_default_str();
  command->add_flag("--several-hosts", options->site.is_several_hosts,
                    "the cell spans several hosts: a ttl above 0 is intended");
  command
      ->add_option("--min-free-mb", options->min_free_mb,
                   "disk space that a run may need")
      ->check(NumberIn<int64_t>(0, int64_t{1} << 40))
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return RunDoctor(*options);
    };
  });
}

}  // namespace cell::cli
