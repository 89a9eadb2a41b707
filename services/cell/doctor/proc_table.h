#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/cell/doctor/machine.h"

namespace cell::cli {

// Reads the tables of the kernel in /proc. Pure.

/// The device that datagrams to `address` ("239.255.76.67") leave by, from the
/// text of /proc/net/route; nothing if no route leads there.
std::optional<std::string> RouteTo(const std::string& address,
                                   const std::string& route_table);

/// Whether a device is up and takes multicast, from the text of /proc/net/igmp.
bool ReceivesMulticast(const std::string& device,
                       const std::string& igmp_table);

struct ProcessName {
  int pid = 0;
  std::string name;
};

/// The processes that have a UDP socket on `port`, by pid. Those of other
/// users are seen by root only.
std::vector<ProcessName> OwnersOfUdpPort(const Machine& machine,
                                         const std::string& root, int port);

/// The whole number that a text begins with.
std::optional<int64_t> FirstNumber(const std::string& text);

}  // namespace cell::cli
