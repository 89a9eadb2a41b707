#pragma once

#include <linux/filter.h>

#include <string>
#include <vector>

namespace cell {

/// A program for the kernel (classic BPF, SO_ATTACH_FILTER of socket(7)) that
/// keeps from a UDP socket the short LCM messages of all channels but these.
/// LCM hands every process each packet of the group; without it a process wakes
/// for each, looks at its channel and sleeps again. Fragments of long messages
/// and other data pass: only the first fragment names its channel.
/// @returns nothing if the kernel takes no program that long
std::vector<sock_filter> ChannelFilter(std::vector<std::string> channels);

/// Descriptors of this process's UDP sockets that receive on the port.
std::vector<int> SocketsOn(int port);

/// @returns false if the kernel refuses; then the socket receives all, as
/// before
bool AttachFilter(int socket, std::vector<sock_filter> program);

}  // namespace cell
