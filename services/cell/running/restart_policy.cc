#include "services/cell/running/restart_policy.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "common/node/run_service.h"

namespace cell::cli {
namespace {

constexpr int kMaxRestarts = 10;

std::string WithoutNumbers(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isdigit(c) != 0; });
  return text;
}

}  // namespace

std::optional<std::string> RestartPolicy::WhyNot(
    const ProcessGroup::Death& death, const std::string& reason) {
  Record& record = records_[death.name];
  const std::string last = std::exchange(
      record.reason, death.exit_code ? WithoutNumbers(reason) : "");
  ++record.num_deaths;
  const auto because = [&](const std::string& why) {
    return reason.empty() ? why : why + ": " + reason;
  };
  if (death.exit_code == kExitUsage || death.exit_code == kExitNoProgram) {
    return because("it would fail again");
  }
  if (!record.reason.empty() && record.reason == last) {
    return because("it fails again for the same reason");
  }
  if (record.num_deaths > kMaxRestarts) {
    return because("it has died " + std::to_string(record.num_deaths) +
                   " times");
  }
  return std::nullopt;
}

}  // namespace cell::cli
