#include "common/planning/relaxation.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/planning/ground_model.h"
#include "common/planning/planner.h"
#include "tests/unit/planning/ppddl_task.h"

namespace cell::planning {
namespace {

TEST(Relaxation, AGoalOutOfReachIsADeadEnd) {
  GroundTask task = Propositional(
      3,
      "(:action f :precondition (not (p1)) :effect (and (p2) (p1)))"
      "(:action g :effect (probabilistic 0.5 (p0)))",
      "", "(p2)");
  const Relaxation relaxation(task);
  std::vector<uint64_t> start(1);
  EXPECT_EQ(relaxation.Assess(start).max_probability, 1);
  // With p1, which nothing undoes, f never applies.
  for (size_t atom = 0; atom < task.atoms.size(); ++atom) {
    std::vector<uint64_t> state = {uint64_t{1} << atom};
    const bool is_dead = Show(task.atoms[atom]) == "p1()";
    EXPECT_EQ(relaxation.Assess(state).max_probability, is_dead ? 0 : 1);
  }
}

TEST(Relaxation, LeastActionsCountTheLayers) {
  const GroundTask task = Propositional(
      4,
      "(:action f :effect (p0)) (:action g :precondition (p0) :effect (p1))"
      "(:action h :precondition (and (p0) (p1)) :effect (p2))",
      "", "(p2)");
  std::vector<uint64_t> start(1);
  EXPECT_EQ(Relaxation(task).Assess(start).least_actions, 3);
}

/// A task of random actions, with negative and conditional literals, clauses,
/// and uncertain outcomes.
class RandomTask {
 public:
  explicit RandomTask(uint64_t seed) : random_(seed) {}

  GroundTask Make() {
    GroundTask task;
    for (int i = 0; i < kNumAtoms; ++i) {
      task.atoms.push_back({"p" + std::to_string(i), {}});
      task.initial.push_back(Draw(2) == 0);
    }
    for (int a = 0; a < 5; ++a) {
      GroundAction action{"a" + std::to_string(a), Condition(), {}};
      double left = 1;
      const int num_outcomes = 1 + Draw(2);
      for (int o = 0; o < num_outcomes; ++o) {
        Outcome outcome{o + 1 == num_outcomes ? left : 0.25, {}};
        left -= outcome.probability;
        const int num_effects = 1 + Draw(2);
        for (int e = 0; e < num_effects; ++e) {
          outcome.effects.push_back(
              {Draw(2) == 0 ? Conjunction{} : Condition(), {Any()}});
        }
        action.outcomes.push_back(std::move(outcome));
      }
      task.actions.push_back(std::move(action));
    }
    task.goals = {Conjunction{{Any(), Any()}, {}}, Condition()};
    return task;
  }

 private:
  static constexpr int kNumAtoms = 6;

  int Draw(int below) {
    return static_cast<int>(random_() % static_cast<uint64_t>(below));
  }
  Literal Any() { return {Draw(kNumAtoms), Draw(2) == 0}; }
  Conjunction Condition() {
    Conjunction condition{{Any(), Any()}, {}};
    if (Draw(3) == 0) condition.clauses = {{Any(), Any()}};
    return condition;
  }

  std::mt19937_64 random_;
};

/// The task without any estimate: no dead ends, no cleared atoms.
class BlindModel final : public Model {
 public:
  explicit BlindModel(const GroundTask& task) : model_(task) {}
  int num_words() const override { return model_.num_words(); }
  bool IsGoal(Bits state) const override { return model_.IsGoal(state); }
  void Expand(Bits state, Expansion* expansion) const override {
    model_.Expand(state, expansion);
  }
  std::string ActionName(int action) const override {
    return model_.ActionName(action);
  }

 private:
  GroundModel model_;
};

TEST(Relaxation, EstimatesNeverChangeThePlansValue) {
  int num_uncertain = 0;
  int num_fewer = 0;
  for (uint64_t seed = 0; seed < 3000; ++seed) {
    const GroundTask task = RandomTask(seed).Make();
    const auto model = std::make_shared<GroundModel>(task);
    const Plan plan = Planner(model, {}).Find(model->initial());
    const Plan blind =
        Planner(std::make_shared<BlindModel>(task), {}).Find(model->initial());
    EXPECT_EQ(plan.status, blind.status) << seed;
    EXPECT_NEAR(plan.probability.low, blind.probability.low, 1e-8) << seed;
    EXPECT_NEAR(plan.expected_actions, blind.expected_actions, 1e-6) << seed;
    num_uncertain += blind.probability.low > 0 && blind.probability.low < 0.99;
    num_fewer += plan.num_expansions < blind.num_expansions;
  }
  EXPECT_GT(num_uncertain, 20);
  EXPECT_GT(num_fewer, 100);
}

}  // namespace
}  // namespace cell::planning
