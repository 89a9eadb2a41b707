#include "services/supervisor/stop_policy.h"

#include <algorithm>
#include <cmath>

namespace cell::supervisor {
namespace {

constexpr double kLongestMs = 60'000;

Hold HoldFromConfig(const Config& config) {
  const auto name = config.As<std::string>();
  if (name == "at_once") return Hold::kAtOnce;
  if (name == "at_boundary") return Hold::kAtBoundary;
  if (name == "alert_only") return Hold::kNone;
  config.Fail("'" + name + "' is not one of at_once, at_boundary, alert_only");
}

AlertLevel LevelFromConfig(const Config& config) {
  const auto name = config.As<std::string>();
  if (name == "info") return AlertLevel::kInfo;
  if (name == "warning") return AlertLevel::kWarning;
  if (name == "error") return AlertLevel::kError;
  config.Fail("'" + name + "' is not one of info, warning, error");
}

int64_t SilenceOf(const Config& config) {
  return std::llround(1e3 * config.Number("silence_ms", 1, kLongestMs));
}

}  // namespace

StopPolicy StopPolicy::FromConfig(const Config& config, const Roster& roster,
                                  const std::string& self) {
  StopPolicy table;
  table.operator_hold = HoldFromConfig(config["operator_hold"]);
  if (table.operator_hold == Hold::kNone) {
    config["operator_hold"].Fail(
        "an operator's hold must stop the arms: at_once or at_boundary");
  }
  const int64_t silence_us = SilenceOf(config);
  for (const auto& [name, node] : config["services"].Entries()) {
    const HoldRow row{name, HoldFromConfig(node["when_silent"]),
                      node.Has("silence_ms") ? SilenceOf(node) : silence_us,
                      LevelFromConfig(node["level"]),
                      node.Get<std::string>("means")};
    if (std::ranges::count(roster.absent, name) > 0) continue;
    const auto index = roster.IndexOf(name);
    if (!index) node.Fail("is not in the roster");
    if (*index == 0 || name == self) node.Fail("cannot be watched from here");
    table.rows.push_back(row);
  }
  for (size_t i = 1; i < roster.entries.size(); ++i) {
    const std::string& name = roster.entries[i].name;
    const bool is_there =
        std::any_of(table.rows.begin(), table.rows.end(),
                    [&](const HoldRow& row) { return row.service == name; });
    if (!is_there && name != self) {
      config["services"].Fail("lacks '" + name + "', which is in the roster");
    }
  }
  return table;
}

}  // namespace cell::supervisor
