#include "services/supervisor/safety_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell::supervisor {

SafetyMonitor::SafetyMonitor(StopPolicy table, int64_t now)
    : operator_hold_(table.operator_hold) {
  for (HoldRow& row : table.rows) rows_.push_back({std::move(row), now});
}

void SafetyMonitor::OnMessage(const std::string& service, int64_t now) {
  const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) {
    return row.row.service == service;
  });
  if (it != rows_.end()) it->heard = now;
}

void SafetyMonitor::OnIncarnation(const std::string& service,
                                  int32_t incarnation) {
  const auto [known, is_first] =
      incarnations_.try_emplace(service, incarnation);
  if (is_first || incarnation <= known->second) return;
  known->second = incarnation;
  Note(AlertLevel::kWarning, Event::Cause::kRestarted,
       service + " has restarted and lost the work in progress");
}

std::vector<Event> SafetyMonitor::Update(int64_t now) {
  for (Row& row : rows_) {
    const bool is_silent = now - row.heard > row.row.silence_us;
    if (is_silent == row.is_silent) continue;
    row.is_silent = is_silent;
    const std::string& name = row.row.service;
    if (!is_silent) {
      silent_.erase(name);
      Note(AlertLevel::kInfo, Event::Cause::kSilent,
           name + " is no longer silent");
      continue;
    }
    const auto seconds = [](int64_t us) {
      return 1e-6 * static_cast<double>(us);
    };
    const std::string text = fmt::format(
        "{} has been silent for {:.3f} s, more than the {:.3f} s allowed: {}",
        name, seconds(now - row.heard), seconds(row.row.silence_us),
        row.row.meaning);
    if (row.row.hold != Hold::kNone) silent_[name] = {row.row.hold, text};
    Note(row.row.level, Event::Cause::kSilent, text);
  }
  return std::exchange(events_, {});
}

void SafetyMonitor::HoldByOperator() {
  const bool is_new =
      operators_
          .try_emplace("", Cause{operator_hold_, "the operator holds the cell"})
          .second;
  if (!is_new) return;
  Note(AlertLevel::kInfo, Event::Cause::kHeld, operators_.at("").reason);
}

void SafetyMonitor::StopProtectively(const std::string& arm,
                                     const std::string& why) {
  const std::string reason = fmt::format(
      "the {} arm has made a protective stop: {}; check the arm, then resume",
      arm, why);
  if (!operators_.try_emplace(arm, Cause{Hold::kAtOnce, reason}).second) return;
  Note(AlertLevel::kError, Event::Cause::kHeld, reason);
}

void SafetyMonitor::ResumeByOperator() {
  if (operators_.empty()) return;
  operators_.clear();
  Note(AlertLevel::kInfo, Event::Cause::kHeld,
       "the operator has resumed the cell");
}

Operation SafetyMonitor::operation() const {
  Operation operation;
  if (agent_) {
    operation.mode = *agent_ == Agent::kRobot ? Mode::kExecute : Mode::kMonitor;
  }
  operation.is_operators = operators_.contains("");
  for (const auto* causes : {&operators_, &silent_}) {
    for (const auto& [name, cause] : *causes) {
      operation.mode = Mode::kHold;
      operation.hold = std::max(operation.hold, cause.hold);
      if (!operation.reason.empty()) operation.reason += "; ";
      operation.reason += cause.reason;
    }
  }
  return operation;
}

void SafetyMonitor::Note(AlertLevel level, Event::Cause cause,
                         std::string text) {
  events_.push_back({level, cause, std::move(text)});
}

}  // namespace cell::supervisor
