#pragma once

namespace cell {

/// Moves the calling process (before it starts threads) into a network of its
/// own: loopback only, with a multicast route. No process outside gets what it
/// sends there. Needs root or unprivileged user namespaces.
/// @throws std::system_error that names the step which failed.
void EnterPrivateNetwork();

/// Moves the calling process (before it starts threads) into the network of
/// another process of this user, e.g. one that has entered a private one.
/// @throws std::system_error that names the step which failed.
void JoinNetworkOf(int pid);

}  // namespace cell
