#include "common/bus/private_network.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <net/if.h>
#include <net/route.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace cell {
namespace {

void Require(bool is_done, const std::string& step) {
  if (!is_done) throw std::system_error(errno, std::generic_category(), step);
}

sockaddr InternetAddress(const char* dotted) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, dotted, &address.sin_addr);
  sockaddr generic{};
  std::memcpy(&generic, &address, sizeof(generic));
  return generic;
}

void RaiseLoopback(int socket_fd) {
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  request.ifr_flags = IFF_UP | IFF_RUNNING | IFF_MULTICAST;
  Require(ioctl(socket_fd, SIOCSIFFLAGS, &request) == 0,
          "raising the loopback device");
}

void RouteMulticastToLoopback(int socket_fd) {
  std::string device = "lo";
  rtentry route{};
  route.rt_dst = InternetAddress("224.0.0.0");
  route.rt_genmask = InternetAddress("240.0.0.0");
  route.rt_flags = RTF_UP;
  route.rt_dev = device.data();
  Require(ioctl(socket_fd, SIOCADDRT, &route) == 0,
          "adding the multicast route");
}

/// `kind` as in /proc/PID/ns.
void JoinNamespaceOf(int pid, const std::string& kind) {
  const std::string path = "/proc/" + std::to_string(pid) + "/ns/" + kind;
  const int ns_fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  Require(ns_fd >= 0, "opening " + path);
  const int result = setns(ns_fd, 0);
  const int error = errno;
  close(ns_fd);
  errno = error;
  Require(result == 0, "joining the network of process " + std::to_string(pid));
}

/// Enters a new network namespace. Without the right to do so, as root in some
/// containers, it enters a user namespace of its own first.
bool MaySetUpNetworks() {
  return geteuid() == 0 && prctl(PR_CAPBSET_READ, CAP_NET_ADMIN, 0, 0, 0) == 1;
}

}  // namespace

void EnterPrivateNetwork() {
  const int flags =
      MaySetUpNetworks() ? CLONE_NEWNET : CLONE_NEWUSER | CLONE_NEWNET;
  Require(unshare(flags) == 0,
          "making a private network (needs root or "
          "sysctl kernel.unprivileged_userns_clone=1)");
  const int socket_fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  Require(socket_fd >= 0, "opening a socket");
  RaiseLoopback(socket_fd);
  RouteMulticastToLoopback(socket_fd);
  close(socket_fd);
}

void JoinNetworkOf(int pid) {
  // Without root, the network was made in a user namespace of the same user,
  // which has to be joined first.
  if (geteuid() != 0) JoinNamespaceOf(pid, "user");
  JoinNamespaceOf(pid, "net");
}

}  // namespace cell
