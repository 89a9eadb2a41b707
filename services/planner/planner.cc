#include "services/planner/planner.h"

#include <limits>
#include <string>
#include <utility>

#include "cell/alert_t.hpp"
#include "common/parts/part_table.h"
#include "services/planner/planner_messages.h"

namespace cell {
namespace {

Agent AgentFromConfig(const Config& config) {
  const auto name = config.As<std::string>();
  if (name == "person") return Agent::kPerson;
  if (name == "robot") return Agent::kRobot;
  config.Fail("'" + name + "' is neither person nor robot");
}

Planner::Params LoadParams(const Deployment& deployment) {
  const Config parts = deployment.OfTask("parts.yaml");
  const Config domain = deployment.OfTask("domain.yaml");
  const Config config = deployment.ForService("planner");
  Planner::Params params{
      Domain::FromConfig(domain, PartTable::FromConfig(parts)), {}, {}};
  params.domain.PassOverGeometry();
  params.domain.PassOverSec();
  domain.Finish();
  params.search.agent = AgentFromConfig(config["agent"]);
  params.search.max_states =
      config.Integer("max_states", 1, std::numeric_limits<int>::max());
  params.monitor.min_detour =
      config.Number("min_detour", 0, std::numeric_limits<double>::max());
  params.monitor.max_remembered = config.Integer("max_remembered", 1, 1 << 20);
  config.Finish();
  return params;
}

}  // namespace

Planner::Planner(Bus& bus, Params params)
    : bus_(bus), params_(std::move(params)) {
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  bus_.Subscribe<predicates_t>(
      "PREDICATES", [this](const auto& m) { return OnPredicates(m); });
  bus_.Subscribe<action_t>("ACTION",
                           [this](const auto& m) { return OnAction(m); });
}

bool Planner::OnEpisode(const episode_t& message) {
  if (message.phase == episode_t::END) return true;
  if (message.phase == episode_t::RUNNING && monitor_) return true;
  if (message.phase != episode_t::START &&
      message.phase != episode_t::RUNNING) {
    return false;
  }
  monitor_.reset();
  start_utime_ = message.phase == episode_t::START ? message.header.utime : 0;
  const Goal* goal = params_.domain.FindGoal(message.goal);
  if (goal != nullptr) {
    monitor_.emplace(PlanSearch(params_.domain, *goal, params_.search),
                     params_.monitor);
    return true;
  }
  alert_t alert{};
  alert.header.utime = message.header.utime;
  alert.level = alert_t::ERROR;
  alert.cause = alert_t::BAD_INPUT;
  alert.text = "The task has no goal '" + message.goal + "', but:";
  for (const Goal& known : params_.domain.goals()) {
    alert.text += " " + known.name;
  }
  bus_.Publish("ALERT", alert);
  return true;
}

bool Planner::OnPredicates(const predicates_t& message) {
  if (message.header.utime < start_utime_) return true;  // of the one before
  const auto sensed = FromMessage(message, params_.domain);
  if (sensed && monitor_) Publish(monitor_->Take(*sensed));
  return sensed.has_value();
}

bool Planner::OnAction(const action_t& message) {
  if (message.header.utime < start_utime_) return true;  // of the one before
  const auto action = FromMessage(message, params_.domain);
  if (action && monitor_) Publish(monitor_->Take(*action));
  return action.has_value();
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

}  // namespace cell
