#include "services/cell/doctor/system_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "services/cell/doctor/proc_table.h"

namespace cell::cli {
namespace {

// Several hosts compare stamps; one does not.
Diagnosis CheckTimeService(const Machine& machine, const Site& site) {
  const std::string system = site.root + "/etc/systemd/system/";
  for (const char* service : {"sysinit.target.wants/systemd-timesyncd.service",
                              "multi-user.target.wants/chrony.service",
                              "multi-user.target.wants/ntpsec.service",
                              "multi-user.target.wants/openntpd.service"}) {
    if (machine.LinkAt(system + service)) {
      return Diagnosis::Ok(fmt::format("{} sets it", service));
    }
  }
  const std::string what = "no service keeps the clock right (NTP)";
  const std::string fix = fmt::format(
      "systemctl {}enable systemd-timesyncd",
      site.root.empty() ? "--now " : fmt::format("--root={} ", site.root));
  return site.is_several_hosts ? Diagnosis::Bad(what, fix)
                               : Diagnosis::Warning(what, fix);
}

// Cores that clock down take longer than their tick.
Diagnosis CheckGovernor(const Machine& machine, const Site& site) {
  const std::string cpus = site.root + "/sys/devices/system/cpu";
  std::string slow;
  for (const std::string& cpu : machine.List(cpus)) {
    const std::string path =
        fmt::format("{}/{}/cpufreq/scaling_governor", cpus, cpu);
    const auto governor = machine.Read(path);
    if (governor && governor->starts_with("powersave")) slow += " " + path;
  }
  if (slow.empty()) return Diagnosis::Ok("no processor is slowed down");
  return Diagnosis::Warning(
      "processors are slowed down (governor powersave): ticks may be late",
      fmt::format("echo performance | tee{} > /dev/null", slow));
}

Diagnosis CheckUserNamespaces(const Machine& machine, const Site& site) {
  const std::string path =
      site.root + "/proc/sys/kernel/unprivileged_userns_clone";
  const auto text = machine.Read(path);
  if (!text || FirstNumber(*text) != 0) {
    return Diagnosis::Ok("users may make private networks");
  }
  return Diagnosis::Bad(
      "users may not make private networks: `cell demo` and tests need root",
      fmt::format("echo 1 > {}", path));
}

// Folders below runs_dir that look like a run, the oldest first.
std::vector<std::pair<int64_t, std::string>> RunsOf(const Machine& machine,
                                                    const Site& site) {
  std::vector<std::pair<int64_t, std::string>> runs;
  for (const std::string& name : machine.List(site.runs_dir)) {
    const std::string path = site.runs_dir + "/" + name;
    const auto status = machine.StatusOf(path);
    if (status && status->is_folder && machine.Exists(path + "/run.yaml")) {
      runs.emplace_back(status->mtime_s, path);
    }
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

Diagnosis CheckRunsFolder(const Machine& machine, const Site& site) {
  const auto status = machine.StatusOf(site.runs_dir);
  if (!status) {
    return Diagnosis::Ok(site.runs_dir + " will be created by the first run");
  }
  if (!status->is_folder) {
    return Diagnosis::Bad(
        site.runs_dir + " is not a folder: runs cannot be stored",
        fmt::format("mv {0} {0}.moved", site.runs_dir));
  }
  if ((status->mode & 0700) != 0700) {
    return Diagnosis::Bad(fmt::format("{} has mode {:o}: runs cannot be stored",
                                      site.runs_dir, status->mode),
                          "chmod u+rwx " + site.runs_dir);
  }
  return Diagnosis::Ok(site.runs_dir + " can be written");
}

Diagnosis CheckDisk(const Machine& machine, const Site& site) {
  std::string folder = site.runs_dir;
  auto free = machine.FreeBytes(folder);
  if (!free) free = machine.FreeBytes(folder = ".");
  const auto mb = [](int64_t bytes) {
    return bytes >> 20;
  };
  if (free && *free >= site.min_free_bytes) {
    return Diagnosis::Ok(fmt::format("{} MB free in {}", mb(*free), folder));
  }
  const auto runs = RunsOf(machine, site);
  return Diagnosis::Bad(
      fmt::format("{} MB free in {}, should be {}: logs may be cut short",
                  mb(free.value_or(0)), folder, mb(site.min_free_bytes)),
      runs.empty() ? "delete what is no longer needed (df -h " + folder + ")"
                   : "rm -r " + runs.front().second);
}

Diagnosis CheckClock(const Machine& machine, const Site& site) {
  const auto runs = RunsOf(machine, site);
  constexpr int64_t kToleranceS = 60;
  const int64_t now = machine.NowSeconds();
  if (!runs.empty() && runs.back().first > now + kToleranceS) {
    return Diagnosis::Bad(
        fmt::format("{} was written {} s in the future: the clock has jumped "
                    "back. Set it (timedatectl); if it is right now:",
                    runs.back().second, runs.back().first - now),
        "touch " + runs.back().second);
  }
  return Diagnosis::Ok("no run is from the future");
}

Diagnosis CheckStaleRuns(const Machine& machine, const Site& site) {
  constexpr int64_t kStartS = 60;  // one that starts has no log yet
  std::string stale;
  for (const auto& [mtime, path] : RunsOf(machine, site)) {
    const auto files = machine.List(path);
    const bool has_log = std::any_of(
        files.begin(), files.end(),
        [](const std::string& file) { return file.ends_with(".lcmlog"); });
    if (!has_log && mtime + kStartS < machine.NowSeconds()) stale += " " + path;
  }
  if (stale.empty()) return Diagnosis::Ok("every run has a log");
  return Diagnosis::Warning(
      "runs that failed at their start have no log:" + stale, "rm -r" + stale);
}

}  // namespace

std::vector<Check> SystemChecks() {
  return {{"time service", CheckTimeService},
          {"processors", CheckGovernor},
          {"private networks", CheckUserNamespaces},
          {"runs folder", CheckRunsFolder},
          {"disk", CheckDisk},
          {"clock", CheckClock},
          {"stale runs", CheckStaleRuns}};
}

}  // namespace cell::cli
