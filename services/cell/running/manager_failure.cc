#include "services/cell/running/manager_failure.h"

#include <fmt/format.h>

namespace cell::cli {
namespace {

constexpr int kNoSuchProgram = 127;  // of the shell

bool Has(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

std::string Explain(const ManagerFailure& failure) {
  const std::string& output = failure.output;
  if (failure.exit_code == kNoSuchProgram ||
      Has(output, "not been booted with systemd") ||
      (!failure.is_user && Has(output, "Failed to connect to bus"))) {
    return "systemd is not running here (in a container it usually is not); "
           "`cell up`, `cell status` and `cell down` need it. To run a cell "
           "without it: cell demo";
  }
  if (Has(output, "Failed to connect to bus")) {
    return "this user's systemd manager cannot be reached: log in as this "
           "user, not through su or sudo (this sets $XDG_RUNTIME_DIR), or "
           "start it without a login: loginctl enable-linger USER";
  }
  if (Has(output, "not found") || Has(output, "not loaded")) {
    return fmt::format(
        "the cell is not installed: cmake --install build/release, then "
        "systemctl {}daemon-reload",
        failure.is_user ? "--user " : "");
  }
  const bool is_refused = Has(output, "Access denied") ||
                          Has(output, "Permission denied") ||
                          Has(output, "uthentication");
  if (is_refused && !failure.is_root) {
    return "this needs root: sudo cell ...; or run your own cell: --user";
  }
  return "systemctl: " + output;
}

}  // namespace cell::cli
