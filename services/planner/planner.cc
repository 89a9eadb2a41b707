#include "services/planner/planner.h"

#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "cell/alert_t.hpp"
#include "cell/library_request_t.hpp"
#include "cell/sense_request_t.hpp"
#include "common/actions/action_model_reader.h"
#include "common/actions/record_messages.h"
#include "common/task/task.h"
#include "services/planner/executor_messages.h"
#include "services/planner/planner_messages.h"

namespace cell::planner {
namespace {

/// Ticks between two looks for what nobody has recognised.
constexpr int32_t kTellPeriod = 125;
/// [us] What was done in an episode has been recognised so long after its end.
constexpr int64_t kLastWordsUs = 500'000;

std::optional<Agent> FindAgent(const std::string& name) {
  if (name == "person") return Agent::kPerson;
  if (name == "robot") return Agent::kRobot;
  return std::nullopt;
}

std::string InCapitals(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

/// [us]
int64_t Duration(const Config& config, const std::string& key, double high_ms,
                 double low_ms = 0) {
  return std::llround(1e3 * config.Number(key, low_ms, high_ms));
}

/// All ground actions of the actions that are named.
std::set<GroundAction> LoadSteps(const std::vector<Config>& names,
                                 const Domain& domain) {
  std::set<GroundAction> steps;
  for (const Config& name : names) {
    const size_t before = steps.size();
    for (const GroundAction& action : domain.GroundActions(Agent::kRobot)) {
      if (domain.actions()[action.action].name == name.As<std::string>()) {
        steps.insert(action);
      }
    }
    if (steps.size() == before) {
      name.Fail("the robot has no action '" + name.As<std::string>() + "'");
    }
  }
  return steps;
}

Executor::Params LoadExecutor(const Config& config, const Domain& domain,
                              const PlanSearch::Params& search) {
  constexpr double kMinuteMs = 60'000;
  constexpr double kTickMs = 8;  // less is never
  Executor::Params params;
  params.search = search;
  params.search.agent = Agent::kRobot;
  params.settle_us = Duration(config, "settle_ms", kMinuteMs);
  params.deadline_us = Duration(config, "deadline_ms", kMinuteMs, kTickMs);
  params.sense_period_us =
      Duration(config, "sense_period_ms", kMinuteMs, kTickMs);
  params.watch_period_us =
      Duration(config, "watch_period_ms", kMinuteMs, kTickMs);
  params.patience_us = Duration(config, "patience_ms", kMinuteMs);
  params.lost_us = Duration(config, "lost_ms", kMinuteMs, kTickMs);
  params.max_attempts = config.Integer("max_attempts", 1, 100);
  params.parallel = config.Get<bool>("parallel");
  params.help_steps = LoadSteps(config.ItemsOf("help_steps"), domain);
  return params;
}

Planner::Params LoadParams(const Deployment& deployment) {
  const Config config = deployment.ForService("planner");
  Planner::Params params{LoadTask(deployment).domain, {}, {}, {}, {}};
  params.search.max_states =
      config.Integer("max_states", 1, std::numeric_limits<int>::max());
  params.monitor.min_detour =
      config.Number("min_detour", 0, std::numeric_limits<double>::max());
  params.monitor.max_remembered = config.Integer("max_remembered", 1, 1 << 20);
  constexpr double kHourMs = 3'600'000;
  params.unseen.patience_us = Duration(config, "unseen_ms", kHourMs);
  params.executor =
      LoadExecutor(config["execution"], params.domain, params.search);
  config.Finish();
  return params;
}

}  // namespace

Planner::Planner(Bus& bus, Params params)
    : bus_(bus), params_(std::move(params)) {
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<command_goal_t>(bus_, "COMMAND_GOAL",
                                 [this](const auto& m) { return OnGoal(m); });
  bus_.Subscribe<operating_mode_t>("MODE",
                                   [this](const auto& m) { return OnMode(m); });
  bus_.Subscribe<predicates_t>(
      "PREDICATES", [this](const auto& m) { return OnPredicates(m); });
  bus_.Subscribe<action_t>("ACTION",
                           [this](const auto& m) { return OnAction(m); });
  bus_.Subscribe<action_record_t>(
      "ACTION_RECORD", [this](const auto& m) { return OnRecord(m); });
  bus_.Subscribe<skill_result_t>("SKILL_RESULT",
                                 [this](const auto& m) { return OnResult(m); });
  const Vocabulary& vocabulary = params_.domain.vocabulary();
  const Arms arms(vocabulary);
  for (const int arm : arms.arms()) {
    const std::string& name = vocabulary.objects()[arm].name;
    bus_.Subscribe<arm_report_t>(
        "ARM_REPORT_" + InCapitals(name),
        [this, name](const auto& m) { return OnReport(name, m); });
  }
  bus_.Every(1, 0, [this] { Decide(); });  // after all messages
  bus_.Every(1, 0, [this] { EndUnseen(); });
  bus_.Every(kTellPeriod, 0, [this] { LookForUnseen(); });
}

bool Planner::OnEpisode(const episode_t& message) {
  if (!std::exchange(has_asked_, true) && message.phase == episode_t::RUNNING) {
    bus_.Publish("LIBRARY_REQUEST",
                 library_request_t{{bus_.now(), 0, 0, 0}, 0});
  }
  if (message.phase == episode_t::END) {
    is_running_ = false;
    end_utime_ = bus_.now();
    executor_.reset();
    return true;
  }
  const bool is_begun = monitor_ || executor_;
  if (message.phase == episode_t::RUNNING && is_begun) return true;
  if (message.phase != episode_t::START &&
      message.phase != episode_t::RUNNING) {
    return false;
  }
  is_running_ = true;
  end_utime_.reset();
  if (unseen_) TellUnseen(unseen_->TakeAll());
  monitor_.reset();
  unseen_.reset();
  executor_.reset();
  // Who joins an episode that runs complains once.
  if (message.phase == episode_t::RUNNING && complained_of_ == message.id) {
    return true;
  }
  complained_of_ = message.id;
  const std::optional<Agent> agent = FindAgent(message.agent);
  if (!agent) {
    Complain(alert_t::BAD_INPUT,
             "The agent of an episode is person or "
             "robot, not '" +
                 message.agent + "'");
    return true;
  }
  const Goal* goal = params_.domain.FindGoal(message.goal);
  if (goal == nullptr) {
    Complain(alert_t::BAD_INPUT, NoGoal(message.goal));
    return true;
  }
  Begin(*agent, *goal, message);
  return true;
}

void Planner::Begin(Agent agent, const Goal& goal, const episode_t& episode) {
  goal_ = goal.name;
  const bool has_joined_late = episode.phase == episode_t::RUNNING;
  start_utime_ = has_joined_late ? 0 : episode.header.utime;
  if (agent == Agent::kRobot) {
    executor_.emplace(params_.domain, goal, params_.executor, bus_.now());
    executor_->Permit(may_act_);
    return;
  }
  Watch(goal);
  unseen_.emplace(params_.domain, params_.unseen, has_joined_late);
  // There may be no further key frame.
  if (has_joined_late) RequestSense();
}

void Planner::Watch(const Goal& goal) {
  monitor_.emplace(PlanSearch(params_.domain, goal, params_.search),
                   params_.monitor);
}

void Planner::RequestSense() {
  bus_.Publish("SENSE_REQUEST", sense_request_t{{bus_.now(), 0, 0, 0}});
}

CommandAnswer Planner::OnGoal(const command_goal_t& message) {
  const Goal* goal = params_.domain.FindGoal(message.goal);
  if (goal == nullptr) return CommandAnswer::Refuse(NoGoal(message.goal));
  if (!is_running_ || !(executor_ || monitor_)) {
    return CommandAnswer::Refuse(
        "no episode runs that could have another goal (cell episode start)");
  }
  goal_ = goal->name;
  if (executor_) executor_->Pursue(*goal);
  if (monitor_) {
    Watch(*goal);
    RequestSense();
  }
  return CommandAnswer::Accept("the episode's goal is now " + goal->name);
}

std::string Planner::NoGoal(const std::string& name) const {
  std::string text = "The task has no goal '" + name + "', but:";
  for (const Goal& known : params_.domain.goals()) text += " " + known.name;
  return text;
}

bool Planner::OnMode(const operating_mode_t& message) {
  const std::optional<bool> may_act = MayActFromMessage(message);
  if (!may_act) return false;
  may_act_ = *may_act;
  if (executor_) executor_->Permit(may_act_);
  return true;
}

bool Planner::OnPredicates(const predicates_t& message) {
  if (message.header.utime < start_utime_) return true;  // of the one before
  if (message.header.utime > bus_.now()) return false;
  auto sensed = FromMessage(message, params_.domain);
  if (!sensed) return false;
  if (executor_) executor_->Take(*sensed);
  if (!monitor_) return true;
  sensed->state = WithoutArms(sensed->state, params_.domain.vocabulary());
  unseen_->Take(*sensed);
  Publish(monitor_->Take(*sensed));
  return true;
}

bool Planner::OnAction(const action_t& message) {
  if (message.header.utime < start_utime_) return true;  // of the one before
  const auto action = FromMessage(message, params_.domain);
  if (!action) return false;
  if (executor_) executor_->Take(*action);
  if (!monitor_) return true;
  unseen_->Take(*action);
  Publish(monitor_->Take(*action));
  return true;
}

bool Planner::OnRecord(const action_record_t& message) {
  try {
    const ActionRecord record = cell::FromMessage(message);
    if (params_.domain.Put(ReadAction(record, params_.domain))) StartOver();
    return true;
  } catch (const ConfigError& e) {
    Complain(alert_t::BAD_INPUT, std::string("ACTION_RECORD ") + e.what());
    return false;
  }
}

/// What was planned by other rules is forgotten, the world is sensed afresh.
void Planner::StartOver() {
  if (!is_running_ || !(executor_ || monitor_)) return;
  episode_t episode{};
  episode.phase = episode_t::RUNNING;
  Begin(executor_ ? Agent::kRobot : Agent::kPerson,
        *params_.domain.FindGoal(goal_), episode);
}

bool Planner::OnReport(const std::string& arm, const arm_report_t& message) {
  const auto report = FromMessage(message, params_.domain, bus_.now());
  if (!report || message.arm != arm) return false;
  if (executor_) executor_->Take(*report);
  return true;
}

bool Planner::OnResult(const skill_result_t& message) {
  const auto result = FromMessage(message, params_.domain, bus_.now());
  if (result && executor_) executor_->Take(*result);
  return result.has_value();
}

void Planner::Decide() {
  if (!executor_) return;
  const Orders orders = executor_->Decide({bus_.now(), bus_.tick()});
  for (const ArmOrder& request : orders.requests) {
    skill_request_t message = ToMessage(request, params_.domain);
    message.header.utime = bus_.now();
    bus_.Publish("SKILL_REQUEST", message);
  }
  if (orders.sense) RequestSense();
  if (orders.plan) {
    bus_.Publish("PLAN", ToMessage(*orders.plan, params_.domain));
  }
  if (orders.execution) Publish(*orders.execution);
}

void Planner::Publish(const Execution& execution) {
  execution_t message = ToMessage(execution, params_.domain);
  message.header.utime = bus_.now();
  bus_.Publish("EXECUTION", message);
  if (execution.state != Execution::State::kStuck) return;
  Complain(alert_t::STUCK, "The robot asks: " + execution.text);
}

/// Who has joined an episode asks until it is told the state: the one who
/// senses may be dead just now.
void Planner::LookForUnseen() {
  if (!unseen_) return;
  if (unseen_->has_joined_late() && !unseen_->has_state()) RequestSense();
  TellUnseen(unseen_->TakeOverdue(bus_.now()));
}

void Planner::EndUnseen() {
  if (!end_utime_ || bus_.now() < *end_utime_ + kLastWordsUs) return;
  end_utime_.reset();
  if (unseen_) TellUnseen(unseen_->TakeAll());
}

void Planner::TellUnseen(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) Complain(alert_t::UNSEEN, text);
}

void Planner::Complain(int8_t cause, const std::string& text) {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = cause == alert_t::BAD_INPUT ? alert_t::ERROR : alert_t::WARNING;
  alert.cause = cause;
  alert.text = text;
  bus_.Publish("ALERT", alert);
}

void Planner::Publish(const Monitor::Report& report) {
  if (report.plan) {
    bus_.Publish("PLAN", ToMessage(*report.plan, params_.domain));
  }
  for (const Alert& alert : report.alerts) {
    bus_.Publish("ALERT", ToMessage(alert));
  }
}

std::unique_ptr<Service> MakePlanner(Bus& bus, const Deployment& deployment) {
  return std::make_unique<Planner>(bus, LoadParams(deployment));
}

}  // namespace cell::planner
