#pragma once

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "tests/system/shell.h"

namespace cell {

/// The hosts of a cell, each a network namespace, on one switch: no way leads
/// from there to the machine's own network. All of it is gone with the process.
class HostNetwork {
 public:
  /// While this object exists, its thread opens and starts things on a host.
  class Stay {
   public:
    Stay(int host, int home) : home_(home) { Enter(host); }
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;
    ~Stay() { setns(home_, CLONE_NEWNET); }

   private:
    int home_;
  };

  /// Moves the calling process to the switch. Needs root or unprivileged user
  /// namespaces. @throws std::runtime_error that names the step which failed.
  explicit HostNetwork(const std::vector<std::string>& hosts) {
    if (geteuid() != 0) BecomeRootOfItsOwn();
    switch_ = NewNetwork();
    Run("ip link add switch type bridge && ip link set switch up");
    for (const std::string& host : hosts) Add(host);
  }
  HostNetwork(const HostNetwork&) = delete;
  HostNetwork& operator=(const HostNetwork&) = delete;
  ~HostNetwork() {
    for (const auto& [name, host] : hosts_) close(host);
    close(switch_);
  }

  [[nodiscard]] Stay On(const std::string& host) const {
    return {hosts_.at(host), switch_};
  }

 private:
  static void Require(bool is_done, const std::string& step) {
    if (!is_done) throw std::system_error(errno, std::generic_category(), step);
  }
  static void Run(const std::string& command) {
    const ShellResult result = Shell(command);
    if (result.code != 0) {
      throw std::runtime_error(command + ": " + result.output);
    }
  }
  static void Enter(int network) {
    Require(setns(network, CLONE_NEWNET) == 0, "entering a host's network");
  }
  // A program that is started has rights only as root.
  static void BecomeRootOfItsOwn() {
    const std::string user = std::to_string(geteuid());
    const std::string group = std::to_string(getegid());
    Require(unshare(CLONE_NEWUSER) == 0, "making a user namespace");
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " + user + " 1";
    std::ofstream("/proc/self/gid_map") << "0 " + group + " 1";
    Require(geteuid() == 0, "becoming root of the user namespace");
  }
  static int NewNetwork() {
    Require(unshare(CLONE_NEWNET) == 0, "making a network");
    const int network = open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
    Require(network >= 0, "opening the network");
    return network;
  }

  // As docs/operating.md says, "Several hosts".
  void Add(const std::string& name) {
    const std::string number = std::to_string(hosts_.size() + 1);
    const std::string port = "port" + number;
    const int host = hosts_[name] = NewNetwork();
    Enter(switch_);
    Run("ip link add " + port + " type veth peer name eth0 netns /proc/" +
        std::to_string(getpid()) + "/fd/" + std::to_string(host));
    Run("ip link set " + port + " master switch up");
    const Stay stay(host, switch_);
    Run("ip link set lo up && ip addr add 10.76.67." + number +
        "/24 dev eth0 && ip link set eth0 up && "
        "ip route replace 224.0.0.0/4 dev eth0");
  }

  int switch_ = -1;
  std::map<std::string, int> hosts_;
};

}  // namespace cell
