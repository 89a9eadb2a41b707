#include "services/cell/doctor/network_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>

#include "services/cell/doctor/proc_table.h"

namespace cell::cli {
namespace {

constexpr char kAddRoute[] = "ip route replace 224.0.0.0/4 dev lo";

bool IsLoopbackUp(const Machine& machine, const Site& site) {
  return ReceivesMulticast(
      "lo", machine.Read(site.root + "/proc/net/igmp").value_or(""));
}

Diagnosis CheckLoopback(const Machine& machine, const Site& site) {
  if (IsLoopbackUp(machine, site)) return Diagnosis::Ok("lo is up");
  return Diagnosis::Bad("lo is down: services cannot hear each other",
                        fmt::format("ip link set lo up && {}", kAddRoute));
}

Diagnosis CheckRoute(const Machine& machine, const Site& site) {
  if (!IsLoopbackUp(machine, site)) {
    return Diagnosis::Ok("(see loopback)");
  }
  const std::string& group = site.address.group;
  const auto route =
      RouteTo(group, machine.Read(site.root + "/proc/net/route").value_or(""));
  if (!route) {
    return Diagnosis::Bad(fmt::format("no route leads to {}: LCM cannot be "
                                      "opened",
                                      group),
                          kAddRoute);
  }
  if (*route != "lo" && !site.is_several_hosts) {
    return Diagnosis::Warning(fmt::format("{} goes to {}: a cell on one host "
                                          "should send its datagrams over lo",
                                          group, *route),
                              kAddRoute);
  }
  return Diagnosis::Ok(fmt::format("{} goes to {}", group, *route));
}

// Of LCM's stock tools, which take their address from the environment.
Diagnosis CheckTtl(const Machine& machine, const Site& site) {
  if (site.is_several_hosts) return Diagnosis::Ok("several hosts");
  if (site.address.ttl > 0) {
    return Diagnosis::Bad(
        fmt::format("--url asks for ttl {}: datagrams leave this host",
                    site.address.ttl),
        "remove ?ttl= from --url, or add --several-hosts");
  }
  const auto url = machine.Environment("LCM_DEFAULT_URL");
  if (!url) return Diagnosis::Ok("LCM_DEFAULT_URL is not set; LCM's ttl is 0");
  const size_t at = url->find("ttl=");
  const bool is_zero = at == std::string::npos || (*url)[at + 4] == '0';
  if (is_zero) return Diagnosis::Ok("LCM_DEFAULT_URL has ttl 0");
  return Diagnosis::Bad(
      fmt::format("LCM_DEFAULT_URL={}: LCM's tools send to other hosts", *url),
      fmt::format("export LCM_DEFAULT_URL='udpm://{}:{}?ttl=0'",
                  site.address.group, site.address.port));
}

// Only the cell's clock may receive on the control port.
Diagnosis CheckControlPort(const Machine& machine, const Site& site) {
  const int port = site.address.port + 1;
  const auto owners = OwnersOfUdpPort(machine, site.root, port);
  std::string names;
  for (const ProcessName& owner : owners) {
    names += fmt::format("{}{} (pid {})", names.empty() ? "" : ", ", owner.name,
                         owner.pid);
  }
  if (owners.empty()) {
    return Diagnosis::Ok(fmt::format("UDP port {} is free", port));
  }
  const auto other =
      std::find_if(owners.begin(), owners.end(),
                   [](const ProcessName& o) { return o.name != "vtb"; });
  if (owners.size() == 1 && other == owners.end()) {
    return Diagnosis::Ok(fmt::format("a cell runs: {}", names));
  }
  const ProcessName& odd = other == owners.end() ? owners.back() : *other;
  return Diagnosis::Bad(
      fmt::format("UDP port {} is for the clock only, but {} listens on it: "
                  "another cell, or a tool on the wrong port",
                  port, names),
      fmt::format("kill {}", odd.pid));
}

constexpr int64_t kReceiveBuffer = 4 << 20;  // what every service asks for
constexpr int64_t kRoomyBuffer = 8 << 20;

Diagnosis CheckBuffer(const Machine& machine, const Site& site) {
  const std::string path = site.root + "/proc/sys/net/core/rmem_max";
  const int64_t size = FirstNumber(machine.Read(path).value_or("")).value_or(0);
  if (size >= kReceiveBuffer) {
    return Diagnosis::Ok(fmt::format("net.core.rmem_max is {}", size));
  }
  return Diagnosis::Bad(fmt::format("net.core.rmem_max is {}, the cell needs "
                                    "{}: camera frames will be lost",
                                    size, kReceiveBuffer),
                        fmt::format("echo {} > {}", kRoomyBuffer, path));
}

// Later names win, /etc/sysctl.conf comes last.
Diagnosis CheckBufferAtBoot(const Machine& machine, const Site& site) {
  std::vector<std::pair<std::string, std::string>> files;  // name, path
  for (const char* folder : {"/usr/lib/sysctl.d", "/etc/sysctl.d"}) {
    for (const std::string& name : machine.List(site.root + folder)) {
      if (name.ends_with(".conf")) {
        files.emplace_back(name, site.root + folder + "/" + name);
      }
    }
  }
  std::stable_sort(
      files.begin(), files.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
  files.emplace_back("", site.root + "/etc/sysctl.conf");
  int64_t size = 0;
  for (const auto& [name, path] : files) {
    std::istringstream lines(machine.Read(path).value_or(""));
    for (std::string line; std::getline(lines, line);) {
      std::erase(line, ' ');
      constexpr std::string_view kKey = "net.core.rmem_max=";
      if (line.starts_with(kKey)) {
        size = FirstNumber(line.substr(kKey.size())).value_or(size);
      }
    }
  }
  if (size >= kReceiveBuffer) {
    return Diagnosis::Ok(fmt::format("it will be {} after a restart", size));
  }
  return Diagnosis::Warning(
      "nothing in sysctl.d raises net.core.rmem_max: it will be too small "
      "after a restart",
      fmt::format("mkdir -p {0}/etc/sysctl.d && echo 'net.core.rmem_max = {1}' "
                  "> {0}/etc/sysctl.d/60-cell.conf",
                  site.root, kRoomyBuffer));
}

}  // namespace

std::vector<Check> NetworkChecks() {
  return {{"loopback", CheckLoopback},
          {"multicast route", CheckRoute},
          {"ttl", CheckTtl},
          {"control port", CheckControlPort},
          {"receive buffer", CheckBuffer},
          {"receive buffer at boot", CheckBufferAtBoot}};
}

}  // namespace cell::cli
