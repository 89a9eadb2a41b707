#include "common/bus/input_alerts.h"

#include "cell/alert_t.hpp"

namespace cell {

bool InputAlerts::Reject(const std::string& channel, const std::string& why) {
  if (!told_.insert(channel).second) return false;
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::WARNING;
  alert.cause = alert_t::BAD_INPUT;
  alert.text = channel + " is rejected: " + why;
  bus_.Publish("ALERT", alert);
  return false;
}

}  // namespace cell
