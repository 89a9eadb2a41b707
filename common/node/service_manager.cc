#include "common/node/service_manager.h"

#include <systemd/sd-daemon.h>

#include <chrono>
#include <cstdint>

namespace cell {

ProcessHooks ReportToServiceManager() {
  using std::chrono::steady_clock;
  ProcessHooks hooks;
  hooks.on_ready = [] {
    sd_notify(0, "READY=1");
  };
  uint64_t watchdog_us = 0;
  if (sd_watchdog_enabled(0, &watchdog_us) <= 0) return hooks;
  const auto period = std::chrono::microseconds(watchdog_us / 3);
  hooks.on_alive = [period, last = steady_clock::time_point{}]() mutable {
    const auto now = steady_clock::now();
    if (now - last < period) return;
    last = now;
    sd_notify(0, "WATCHDOG=1");
  };
  return hooks;
}

void ReportReasonToServiceManager(const std::string& reason) {
  const std::string line = reason.substr(0, reason.find('\n'));
  sd_notify(0, ("STATUS=" + line).c_str());
}

}  // namespace cell
