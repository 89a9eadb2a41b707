#include "common/rexd/test_run.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "common/planning/ground_model.h"
#include "common/planning/planner.h"
#include "common/rexd/rule_task.h"
#include "common/rules/simulation.h"

namespace cell::rexd {

using namespace rules;
namespace {

/// The rules when the likeliest outcome that changes something is certain.
NdrRules Determinize(NdrRules rules) {
  for (Rule& rule : rules.rules) {
    std::erase_if(rule.outcomes, [](const Outcome& outcome) {
      return outcome.changes.empty();
    });
    rule.noise = rule.outcomes.empty() ? 1 : 0;
    if (rule.outcomes.empty()) continue;
    Outcome likeliest =
        *std::ranges::max_element(rule.outcomes, {}, &Outcome::probability);
    likeliest.probability = 1;
    rule.outcomes = {std::move(likeliest)};
  }
  return rules;
}

/// The plan by the rules, from one state on.
class RulePolicy {
 public:
  RulePolicy(RuleTask task, const World& world, int64_t max_expansions)
      : task_(std::move(task)),
        world_(world),
        model_(std::make_shared<planning::GroundModel>(task_.task)),
        planner_(model_, PlannerParams(max_expansions)) {}

  bool FindFrom(const WorldState& state) {
    return planner_.Find(Pack(state)).status == planning::Plan::Status::kFound;
  }
  std::optional<GroundAct> ActIn(const WorldState& state) const {
    const auto action = planner_.ActionIn(Pack(state));
    if (!action) return std::nullopt;
    return task_.act_of[static_cast<size_t>(*action)];
  }

 private:
  static planning::Planner::Params PlannerParams(int64_t max_expansions) {
    planning::Planner::Params params;
    params.max_expansions = max_expansions;
    params.precision = 1e-3;
    params.minimize_actions = false;
    return params;
  }

  std::vector<uint64_t> Pack(const WorldState& state) const {
    std::vector<bool> atoms;
    for (const Literal& atom : task_.atoms) {
      atoms.push_back(Holds(atom, {}, state, world_));
    }
    return model_->Pack(atoms);
  }

  RuleTask task_;
  const World& world_;
  std::shared_ptr<planning::GroundModel> model_;
  planning::Planner planner_;
};

}  // namespace

TestRun RunTest(const NdrRules& rules, const RexdTask& task,
                const TestRunParams& params) {
  TestRun run;
  WorldState state = task.initial;
  run.is_goal_reached = task.IsGoal(state);
  if (run.is_goal_reached) return run;
  auto ground = GroundRuleTask(Determinize(rules), task, state,
                               GroundActs(*task.world, task.initial));
  if (!ground) return run;
  RandomNumbers random(params.seed);
  RulePolicy policy(*std::move(ground), *task.world, params.max_expansions);
  if (!policy.FindFrom(state)) return run;
  while (!run.is_goal_reached && run.num_actions < params.max_actions) {
    auto act = policy.ActIn(state);
    if (!act && policy.FindFrom(state)) act = policy.ActIn(state);
    if (!act) break;
    state = Simulate(task.truth, *task.world, *act, state, &random);
    ++run.num_actions;
    run.is_goal_reached = task.IsGoal(state);
  }
  return run;
}

}  // namespace cell::rexd
