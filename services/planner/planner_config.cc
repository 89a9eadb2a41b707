#include "services/planner/planner_config.h"

#include <cmath>
#include <limits>
#include <utility>

#include "services/planner/plan_search.h"

namespace cell::planner {
namespace {

constexpr double kMinuteMs = 60'000;
constexpr double kTickMs = 8;  // less is never

/// [us]
int64_t Duration(const Config& config, const std::string& key, double high_ms,
                 double low_ms = 0) {
  return std::llround(1e3 * config.Number(key, low_ms, high_ms));
}

/// All ground actions of the actions that are named.
std::set<GroundAction> LoadSteps(const std::vector<Config>& names,
                                 const RuleSet& rules) {
  std::set<GroundAction> steps;
  for (const Config& name : names) {
    const size_t before = steps.size();
    for (const GroundAction& action : rules.GroundActions(Agent::kRobot)) {
      if (rules.ActionOf(action).name == name.As<std::string>()) {
        steps.insert(action);
      }
    }
    if (steps.size() == before) {
      name.Fail("the robot has no action '" + name.As<std::string>() + "'");
    }
  }
  return steps;
}

ExecutionParams LoadExecution(const Config& config, const RuleSet& rules) {
  ExecutionParams params;
  params.settle_us = Duration(config, "settle_ms", kMinuteMs);
  params.dispatch.deadline_us =
      Duration(config, "deadline_ms", kMinuteMs, kTickMs);
  params.sense_period_us =
      Duration(config, "sense_period_ms", kMinuteMs, kTickMs);
  params.watch_period_us =
      Duration(config, "watch_period_ms", kMinuteMs, kTickMs);
  params.patience_us = Duration(config, "patience_ms", kMinuteMs);
  params.dispatch.lost_us = Duration(config, "lost_ms", kMinuteMs, kTickMs);
  params.lesson_us = Duration(config, "lesson_ms", kMinuteMs);
  params.dispatch.max_attempts = config.Integer("max_attempts", 1, 100);
  params.parallel = config.Get<bool>("parallel");
  params.help_steps = LoadSteps(config.ItemsOf("help_steps"), rules);
  return params;
}

Exploration LoadExploration(const Config& config, const RuleSet& rules) {
  std::set<std::string> shipped;
  for (const Action& action : rules.actions()) {
    if (!action.rules.empty()) shipped.insert(action.name);
  }
  return {.known_count = config.Integer("known_count", 1, 1000),
          .needs_confirmation = config.Get<bool>("confirmation"),
          .shipped = std::move(shipped),
          .experiences = std::make_shared<const std::vector<TaskExperience>>()};
}

Watch::Params LoadWatch(const Config& config) {
  constexpr double kHourMs = 3'600'000;
  Watch::Params params;
  params.monitor.min_detour =
      config.Number("min_detour", 0, std::numeric_limits<double>::max());
  params.monitor.max_remembered = config.Integer("max_remembered", 1, 1 << 20);
  params.unexplained.patience_us = Duration(config, "unseen_ms", kHourMs);
  return params;
}

}  // namespace

std::unique_ptr<DecisionMaker> LoadDecisionMaker(const Domain& domain,
                                                 const Deployment& deployment) {
  const auto rules = RuleSet::FromDomain(domain);
  const Config config = deployment.ForService("planner");
  DecisionMaker::Params params;
  params.goals = domain.goals();
  params.make_solver = PlanSearch::Maker(
      {config.Integer("max_states", 1, std::numeric_limits<int>::max())});
  params.watch = LoadWatch(config);
  params.watch.monitor.requests = domain.requests();
  params.execution = LoadExecution(config["execution"], *rules);
  const Exploration exploration =
      LoadExploration(config["exploration"], *rules);
  if (config.Get<bool>("learning")) params.execution.exploration = exploration;
  params.execution.requests = domain.requests();
  config.Finish();
  return std::make_unique<DecisionMaker>(rules, std::move(params));
}

}  // namespace cell::planner
