// The planner against exact enumeration of all policies.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/planning/planner.h"

namespace cell::planning {
namespace {

struct TableOutcome {
  int state;
  double probability;
};
using TableAction = std::vector<TableOutcome>;

/// Six states: 0 is the start, 5 the goal, 4 without actions.
class TableModel final : public Model {
 public:
  static constexpr int kNumStates = 6;
  static constexpr int kGoal = 5;

  explicit TableModel(uint64_t seed) : actions_(kNumStates) {
    std::mt19937_64 random(seed);
    const auto draw = [&](int below) {
      return static_cast<int>(random() % static_cast<uint64_t>(below));
    };
    for (int s = 0; s < 4; ++s) {
      actions_[static_cast<size_t>(s)].resize(static_cast<size_t>(1 + draw(3)));
      for (TableAction& action : actions_[static_cast<size_t>(s)]) {
        // Eighths, so that equal sums are equal; often certain, for loops.
        int left = 8;
        while (left > 0) {
          const int part = draw(2) == 0 ? left : 1 + draw(left);
          const int target = draw(5) == 0 ? kGoal : draw(5);
          action.push_back({target, part / 8.0});
          left -= part;
        }
      }
    }
  }

  int num_words() const override { return 1; }
  bool IsGoal(Bits state) const override { return state[0] == kGoal; }
  void Expand(Bits state, Expansion* expansion) const override {
    const auto& actions = actions_[state[0]];
    for (size_t a = 0; a < actions.size(); ++a) {
      expansion->BeginChoice(static_cast<int>(a));
      for (const auto& [target, probability] : actions[a]) {
        expansion->AddOutcome(probability, state)[0] =
            static_cast<uint64_t>(target);
      }
    }
  }
  std::string ActionName(int action) const override {
    return std::to_string(action);
  }

  const std::vector<std::vector<TableAction>>& actions() const {
    return actions_;
  }

 private:
  std::vector<std::vector<TableAction>> actions_;
};

struct Value {
  double probability = 0;
  double weighted_actions = 0;  // probability times expected actions
};

/// Of a policy from the start, by linear equations over the states from which
/// it can reach the goal.
Value Evaluate(const TableModel& model, const std::vector<size_t>& policy) {
  constexpr int n = TableModel::kNumStates;
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(n, n);
  for (int s = 0; s < n; ++s) {
    const auto& actions = model.actions()[static_cast<size_t>(s)];
    if (actions.empty()) continue;
    for (const auto& [t, p] : actions[policy[static_cast<size_t>(s)]]) {
      step(s, t) += p;
    }
  }
  std::vector<bool> reaches(n);
  reaches[TableModel::kGoal] = true;
  for (int i = 0; i < n; ++i) {
    for (int s = 0; s < n; ++s) {
      for (int t = 0; t < n; ++t) {
        if (step(s, t) > 0 && reaches[static_cast<size_t>(t)]) {
          reaches[static_cast<size_t>(s)] = true;
        }
      }
    }
  }
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd to_goal = Eigen::VectorXd::Zero(n);
  to_goal[TableModel::kGoal] = 1;
  for (int s = 0; s < n; ++s) {
    if (s == TableModel::kGoal || !reaches[static_cast<size_t>(s)]) continue;
    for (int t = 0; t < n; ++t) {
      if (reaches[static_cast<size_t>(t)]) system(s, t) -= step(s, t);
    }
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(system);
  const Eigen::VectorXd probability = lu.solve(to_goal);
  Eigen::VectorXd costs = probability;
  costs[TableModel::kGoal] = 0;
  const Eigen::VectorXd weighted = lu.solve(costs);
  return {probability[0], weighted[0]};
}

/// The best of all policies.
Value Enumerate(const TableModel& model) {
  std::vector<size_t> policy(TableModel::kNumStates);
  Value best{-1, 0};
  while (true) {
    const Value value = Evaluate(model, policy);
    const double gain = value.probability - best.probability;
    if (gain > 1e-10 ||
        (gain > -1e-10 && value.weighted_actions < best.weighted_actions)) {
      best = value;
    }
    size_t s = 0;
    while (s < policy.size() &&
           ++policy[s] >= std::max<size_t>(1, model.actions()[s].size())) {
      policy[s++] = 0;
    }
    if (s == policy.size()) return best;
  }
}

constexpr uint64_t kStart[] = {0};

TEST(RandomMdp, PlansAreAsGoodAsTheBestOfAllPolicies) {
  int num_uncertain = 0;
  for (uint64_t seed = 0; seed < 600; ++seed) {
    const auto model = std::make_shared<TableModel>(seed);
    const Value best = Enumerate(*model);
    const Plan plan = Planner(model, {}).Find(kStart);
    EXPECT_LE(plan.probability.low, best.probability + 1e-9) << seed;
    EXPECT_GE(plan.probability.high, best.probability - 1e-9) << seed;
    EXPECT_LE(plan.probability.width(), 2e-9) << seed;
    if (best.probability <= 0) {
      EXPECT_EQ(plan.status, Plan::Status::kNoPlan) << seed;
      continue;
    }
    EXPECT_EQ(plan.status, Plan::Status::kFound) << seed;
    EXPECT_TRUE(plan.is_shortest) << seed;
    EXPECT_NEAR(plan.expected_actions, best.weighted_actions / best.probability,
                1e-6)
        << seed;
    num_uncertain += best.probability < 1;
  }
  EXPECT_GT(num_uncertain, 100);
}

TEST(RandomMdp, ASmallBudgetLeavesAnIntervalThatHoldsTheValue) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const auto model = std::make_shared<TableModel>(seed);
    const double best = Enumerate(*model).probability;
    for (int64_t budget = 1; budget < 4; ++budget) {
      Planner::Params params;
      params.max_expansions = budget;
      const Plan plan = Planner(model, params).Find(kStart);
      EXPECT_LE(plan.probability.low, best + 1e-9) << seed;
      EXPECT_GE(plan.probability.high, best - 1e-9) << seed;
      EXPECT_LE(plan.num_expansions, budget);
    }
  }
}

TEST(RandomMdp, PlansFromAllStatesWithOnePlannerAreTheSameAsWithNewOnes) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const auto model = std::make_shared<TableModel>(seed);
    Planner kept(model, {});
    for (uint64_t s = 0; s < TableModel::kNumStates; ++s) {
      const uint64_t state[] = {s};
      const Plan a = kept.Find(state);
      const Plan b = Planner(model, {}).Find(state);
      EXPECT_EQ(a.status, b.status) << seed;
      EXPECT_NEAR(a.probability.low, b.probability.low, 2e-9) << seed;
      EXPECT_NEAR(a.expected_actions, b.expected_actions, 1e-6) << seed;
    }
  }
}

}  // namespace
}  // namespace cell::planning
