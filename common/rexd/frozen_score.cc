#include "common/rexd/frozen_score.h"

#include <deque>

#include "common/planning/planner.h"
#include "common/rexd/teacher.h"

namespace cell::rexd {

using namespace rules;
namespace {

class FrozenScorer {
 public:
  FrozenScorer(const RexdTask& task, const RexD& learner)
      : task_(task),
        robot_(learner.RobotRules()),
        teacher_(task, 1, {}, 0),
        acts_(GroundActs(*task.world, task.initial)),
        model_(learner.Model()),
        planner_(model_, PlannerParams()) {}

  FrozenScore Score() {
    std::set<std::vector<uint64_t>> seen = {task_.initial.bits};
    std::deque<WorldState> open = {task_.initial};
    for (; !open.empty(); open.pop_front()) {
      const WorldState& state = open.front();
      if (task_.IsGoal(state) || !teacher_.DistanceFrom(state)) continue;
      ++score_.num_states;
      score_.num_valid += IsPlanRight(state);
      for (const GroundAct& act : acts_) {
        const WorldState after = teacher_.Intended(act, state);
        if (after == state) continue;
        AddExpectation(act, state, after);
        if (seen.insert(after.bits).second) open.push_back(after);
      }
    }
    for (const auto& [action, rules] : rules_of_) SetExpectation(action, rules);
    return score_;
  }

 private:
  static planning::Planner::Params PlannerParams() {
    planning::Planner::Params params;
    params.max_expansions = 3000;
    params.precision = 1e-3;
    return params;
  }

  bool IsPlanRight(const WorldState& state) {
    const planning::Plan plan = planner_.Find(model_->Pack(state));
    if (plan.status != planning::Plan::Status::kFound || plan.course.empty()) {
      return false;
    }
    const GroundAct& act =
        model_->acts()[static_cast<size_t>(plan.course[0].action)];
    const WorldState after = teacher_.Intended(act, state);
    return after != state && teacher_.DistanceFrom(after).has_value();
  }

  /// Notes by which rule, and with what probability, the change is expected.
  void AddExpectation(const GroundAct& act, const WorldState& before,
                      const WorldState& after) {
    const auto coverage = FindCoverage(robot_.rules, act, before, *task_.world);
    if (!coverage) return;
    double p = 0;
    for (const Outcome& outcome : coverage->rule->outcomes) {
      if (Apply(outcome, coverage->binding, before, *task_.world) == after) {
        p += outcome.probability;
      }
    }
    rules_of_[act.action][coverage->rule] = p;
  }

  void SetExpectation(int action, const std::map<const Rule*, double>& rules) {
    FrozenScore::Expectation& expectation = score_.expectations[action];
    const Rule* first = robot_.rules.rules.data();
    double sum = 0;
    for (const auto& [rule, p] : rules) {
      const int count = robot_.counts[static_cast<size_t>(rule - first)];
      sum += p * count;
      expectation.num_experiences += count;
    }
    if (expectation.num_experiences > 0) {
      expectation.probability = sum / expectation.num_experiences;
    }
  }

  const RexdTask& task_;
  AgentRules robot_;
  PlanningTeacher teacher_;
  std::vector<GroundAct> acts_;
  std::shared_ptr<RuleModel> model_;
  planning::Planner planner_;
  // Of one array: their order is that of the rules.
  std::map<int, std::map<const Rule*, double>> rules_of_;
  FrozenScore score_;
};

}  // namespace

FrozenScore ScoreFrozen(const RexdTask& task, const RexD& learner) {
  return FrozenScorer(task, learner).Score();
}

}  // namespace cell::rexd
