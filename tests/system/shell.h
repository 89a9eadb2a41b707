#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace cell {

/// What a shell command said (stdout and stderr) and its exit code.
struct ShellResult {
  int code = -1;
  std::string output;
};

/// Runs what follows in a network of its own. Root needs no user namespace,
/// which a chroot would refuse.
inline std::string InPrivateNetwork() {
  return geteuid() == 0 ? "unshare -n " : "unshare -rn ";
}

/// For `unshare`: mounts of its own, too. In a chroot the root's propagation
/// cannot be changed; nothing must be shared with the outside then.
inline std::string WithPrivateMounts() {
  const bool is_chroot =
      std::system("unshare -m true 2>/dev/null") != 0 &&
      std::system("grep -q shared: /proc/self/mountinfo") != 0;
  return is_chroot ? "-m --propagation unchanged " : "-m ";
}

inline ShellResult Shell(const std::string& command) {
  ShellResult result;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> buffer{};
  size_t n = 0;
  while ((n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
    result.output.append(buffer.data(), n);
  }
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

}  // namespace cell
