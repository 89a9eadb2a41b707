#include "services/supervisor/supervisor.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "cell/alert_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "common/bus/roster.h"
#include "common/layout/limit_words.h"

namespace cell::supervisor {
namespace {

constexpr char kName[] = "supervisor";
constexpr char kArmService[] = "robot_arm@";
/// Twice a second: a slow service is activated by messages alone, and has to
/// report often enough.
constexpr int32_t kModePeriod = 62, kModePhase = 31;
/// A skill that ends so soon after a hold was ended by it.
constexpr int64_t kAfterHoldUs = 200'000;

static_assert(static_cast<int>(Mode::kHold) == motion_permit_t::HOLD);
static_assert(static_cast<int>(Hold::kAtOnce) == motion_permit_t::AT_ONCE);
static_assert(static_cast<int>(AlertLevel::kError) == alert_t::ERROR);

int8_t CauseOf(const Event& event) {
  switch (event.cause) {
    case Event::Cause::kSilent:
      return alert_t::SERVICE_SILENT;
    case Event::Cause::kRestarted:
      return alert_t::RESTARTED;
    case Event::Cause::kHeld:
      break;
  }
  return alert_t::HELD;
}

std::string InCapitals(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

Supervisor::Supervisor(Bus& bus, Params params)
    : bus_(bus), params_(std::move(params)) {
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<command_mode_t>(
      bus_, "COMMAND_MODE", [this](const auto& m) { return OnCommand(m); });
  bus_.Subscribe<status_t>("STATUS",
                           [this](const auto& m) { return OnStatus(m); });
  bus_.Subscribe<skill_result_t>("SKILL_RESULT",
                                 [this](const auto& m) { return OnResult(m); });
  for (const std::string& arm : params_.arms) {
    bus_.Subscribe<arm_report_t>(
        "ARM_REPORT_" + InCapitals(arm),
        [this, arm](const auto& m) { return OnReport(arm, m); });
    bus_.Subscribe<arm_state_t>(
        "ARM_STATE_" + InCapitals(arm),
        [this, arm](const auto& m) { return OnState(arm, m); });
    bus_.Subscribe<arm_stop_t>(
        "ARM_STOP_" + InCapitals(arm),
        [this, arm](const auto& m) { return OnStop(arm, m); });
  }
  bus_.Every(1, 0, [this] { OnTick(); });
  bus_.Every(kModePeriod, kModePhase,
             [this] { PublishMode(Watch().operation()); });
}

/// Begins with the first activation: before it there is no time.
SafetyMonitor& Supervisor::Watch() {
  if (!monitor_) monitor_.emplace(params_.table, bus_.now());
  return *monitor_;
}

bool Supervisor::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kEnds) {
    Watch().SetAgent(std::nullopt);
    return true;
  }
  const bool is_robot = message.agent == "robot";
  if (!event || (!is_robot && message.agent != "person")) return false;
  Watch().SetAgent(is_robot ? SafetyMonitor::Agent::kRobot
                            : SafetyMonitor::Agent::kPerson);
  return true;
}

CommandAnswer Supervisor::OnCommand(const command_mode_t& message) {
  switch (message.action) {
    case command_mode_t::HOLD:
      Watch().HoldByOperator();
      return CommandAnswer::Accept("the arms stop, until `cell resume`");
    case command_mode_t::RESUME: {
      Watch().ResumeByOperator();
      const Operation operation = Watch().operation();
      return CommandAnswer::Accept(operation.mode == Mode::kHold
                                       ? "but the cell still holds: " +
                                             operation.reason
                                       : "nothing holds the cell");
    }
    default:
      return CommandAnswer::Refuse("its action is " +
                                   std::to_string(message.action) +
                                   ", neither HOLD (0) nor RESUME (1)");
  }
}

bool Supervisor::OnStatus(const status_t& message) {
  const auto& names = params_.services;
  if (std::find(names.begin(), names.end(), message.service) == names.end()) {
    return false;
  }
  Watch().OnMessage(message.service, bus_.now());
  const int32_t incarnation = message.header.sender / kMaxServices;
  // A supervisor learns from its own first message that it is a restarted one.
  if (message.service == kName && incarnation > 0)
    Watch().OnIncarnation(kName, 0);
  Watch().OnIncarnation(message.service, incarnation);
  return true;
}

bool Supervisor::OnReport(const std::string& arm, const arm_report_t& message) {
  if (message.arm != arm) return false;
  Watch().OnMessage(kArmService + arm, bus_.now());
  // Its first report holds what an earlier supervisor has received.
  const bool is_first = reporting_.insert(arm).second;
  if (is_first && message.is_held_by_operator) Watch().HoldByOperator();
  return true;
}

/// The beginning of a protective stop counts: when it is cleared the device
/// needs a moment to say so.
bool Supervisor::OnState(const std::string& arm, const arm_state_t& message) {
  if (message.servo < arm_state_t::FOLLOWING ||
      message.servo > arm_state_t::STOPPED) {
    return false;
  }
  const int8_t before = std::exchange(
      servos_.try_emplace(arm, arm_state_t::FOLLOWING).first->second,
      message.servo);
  if (message.servo == arm_state_t::STOPPED && before != arm_state_t::STOPPED) {
    stopped_.insert(arm);
  }
  if (message.servo != arm_state_t::STOPPED) why_.erase(arm);
  return true;
}

bool Supervisor::OnStop(const std::string& arm, const arm_stop_t& message) {
  const auto why = WhyStopped(message);
  if (!why || message.arm != arm) return false;
  why_[arm] = *why;
  return true;
}

/// What a hold has stopped is no protective stop.
bool Supervisor::OnResult(const skill_result_t& message) {
  const auto& arms = params_.arms;
  if (message.outcome < skill_result_t::SUCCEEDED ||
      message.outcome > skill_result_t::YIELDED ||
      std::find(arms.begin(), arms.end(), message.arm) == arms.end()) {
    return false;
  }
  Watch().OnMessage(kArmService + message.arm, bus_.now());
  const bool was_held =
      held_utime_ && bus_.now() - *held_utime_ <= kAfterHoldUs;
  if (message.outcome == skill_result_t::STOPPED && !was_held) {
    why_.try_emplace(message.arm, message.reason);
    stopped_.insert(message.arm);
  }
  return true;
}

/// No permit before every arm has reported: one that stopped unseen, or that
/// knows of an operator's hold, must not take the first permit for the
/// operator's resume.
void Supervisor::OnTick() {
  for (const std::string& arm : std::exchange(stopped_, {})) {
    const auto why = why_.find(arm);
    Watch().StopProtectively(
        arm, why == why_.end() ? "its device gave no reason" : why->second);
  }
  for (const Event& event : Watch().Update(bus_.now())) Publish(event);
  const Operation operation = Watch().operation();
  if (operation.mode == Mode::kHold) held_utime_ = bus_.now();
  const size_t num_arms = params_.arms.size();
  if (servos_.size() == num_arms && reporting_.size() == num_arms) {
    PublishPermit(operation);
    if (reported_ != operation) PublishMode(operation);
  }
}

void Supervisor::PublishPermit(const Operation& operation) {
  const bool is_over = operation.hold == Hold::kAtOnce;
  motion_permit_t permit{};
  permit.header.utime = bus_.now();
  permit.until_utime = bus_.now() + (is_over ? 0 : params_.permit_us);
  permit.mode = static_cast<int8_t>(operation.mode);
  permit.hold = static_cast<int8_t>(operation.hold);
  permit.is_held_by_operator = operation.is_operators;
  bus_.Publish("MOTION_PERMIT", permit);
}

void Supervisor::PublishMode(const Operation& operation) {
  reported_ = operation;
  operating_mode_t message{};
  message.header.utime = bus_.now();
  message.mode = static_cast<int8_t>(operation.mode);
  message.hold = static_cast<int8_t>(operation.hold);
  message.reason = operation.reason;
  bus_.Publish("MODE", message);
}

void Supervisor::Publish(const Event& event) {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = static_cast<int8_t>(event.level);
  alert.cause = CauseOf(event);
  alert.text = event.text;
  bus_.Publish("ALERT", alert);
}

std::unique_ptr<Service> MakeSupervisor(Bus& bus,
                                        const Deployment& deployment) {
  const Roster roster = Roster::FromConfig(deployment.ForService("roster"));
  const Config config = deployment.ForService(kName);
  Supervisor::Params params;
  params.table = StopPolicy::FromConfig(config, roster, kName);
  params.permit_us = std::llround(1e3 * config.Number("permit_ms", 8, 1000));
  config.Finish();
  for (const Roster::Entry& entry : roster.entries) {
    params.services.push_back(entry.name);
    if (!entry.name.starts_with(kArmService)) continue;
    params.arms.push_back(entry.name.substr(std::string(kArmService).size()));
  }
  return std::make_unique<Supervisor>(bus, std::move(params));
}

}  // namespace cell::supervisor
