#include "services/planner/plan_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace cell {

using namespace planner;
namespace {

using testing::HasSubstr;

/// A domain given as text, with a search for its goal `done`.
class Puzzle {
 public:
  explicit Puzzle(const std::string& text, int max_states = 100'000)
      : domain_(std::make_unique<Domain>(
            Domain::FromConfig(Config::Parse(text, "problem"), PartTable()))),
        search_({RuleSet::FromDomain(*domain_), *domain_->FindGoal("done"),
                 Agent::kPerson},
                {max_states}) {}

  State With(const std::vector<std::string>& names) const {
    State state(domain_->vocabulary().num_atoms());
    for (const auto& name : names) Set(state, name, Truth::kTrue);
    return state;
  }
  void Set(State& state, const std::string& name, Truth truth) const {
    for (int i = 0; i < state.num_atoms(); ++i) {
      if (domain_->vocabulary().AtomName(i) != name) continue;
      state.Set(i, truth);
      return;
    }
    ADD_FAILURE() << "no atom " << name;
  }
  Plan Find(const std::vector<std::string>& names) {
    return search_.Find(With(names));
  }
  std::string Step(const Plan& plan, size_t i) const {
    return domain_->Show(plan.steps.at(i).action);
  }
  PlanSearch& search() { return search_; }

 private:
  std::unique_ptr<Domain> domain_;
  PlanSearch search_;
};

/// A graph: At(s) for each node, one action Go(X, Y) is too regular, so every
/// edge set is one action of its own without arguments.
std::string Mdp(const std::string& actions) {
  return "types: {node: object}\n"
         "constants: {a: node, b: node, c: node, trap: node, g: node}\n"
         "predicates: {At: {arguments: [node]}}\n"
         "actions:\n" +
         actions + "goals: {done: [At(g)]}\n";
}

std::string Edge(const std::string& name, const std::string& from,
                 const std::vector<std::pair<double, std::string>>& to) {
  double rest = 1;
  std::string text = "  " + name + ":\n    arguments: {}\n    rules:\n" +
                     "      - context: [At(" + from + ")]\n" +
                     "        outcomes:\n";
  for (const auto& [probability, node] : to) {
    rest -= probability;
    text += "          - {probability: " + std::to_string(probability) +
            ", effects: [not At(" + from + "), At(" + node + ")]}\n";
  }
  return text + "        noise: " + std::to_string(rest) + "\n";
}

TEST(PlanSearch, WaitsOutASelfLoop) {
  Puzzle problem(Mdp(Edge("Try", "a", {{0.25, "g"}})));
  const Plan plan = problem.Find({"At(a)"});
  EXPECT_EQ(plan.result, Plan::Result::kFound);
  EXPECT_DOUBLE_EQ(plan.probability, 1);
  EXPECT_DOUBLE_EQ(plan.expected_actions, 4);
  ASSERT_EQ(plan.steps.size(), 1u);
  EXPECT_DOUBLE_EQ(plan.steps[0].probability, 0.25);
}

TEST(PlanSearch, PrefersTheSafeLongWayToTheRiskyShortOne) {
  Puzzle problem(Mdp(Edge("Jump", "a", {{0.9, "g"}, {0.1, "trap"}}) +
                     Edge("Walk", "a", {{0.5, "b"}}) +
                     Edge("Climb", "b", {{0.5, "c"}, {0.5, "a"}}) +
                     Edge("Rest", "c", {{1, "g"}})));
  const Plan plan = problem.Find({"At(a)"});
  EXPECT_NEAR(plan.probability, 1, 1e-9);
  // E(a) = 2 + E(b), E(b) = 1 + (1 + E(a)) / 2.
  EXPECT_NEAR(plan.expected_actions, 7, 1e-9);
  EXPECT_EQ(problem.Step(plan, 0), "Walk()");
  ASSERT_EQ(plan.next.size(), 2u);  // the jump may reach the goal too
  EXPECT_NEAR(plan.next[1].expected_actions, 1, 1e-9);
}

TEST(PlanSearch, AnEndComponentDoesNotPretendToReachTheGoal) {
  // a <-> b for ever keeps an iteration from above at 1; the truth is 0.9.
  Puzzle problem(Mdp(Edge("Forth", "a", {{1, "b"}}) +
                     Edge("Back", "b", {{1, "a"}}) +
                     Edge("Leave", "b", {{0.9, "g"}, {0.1, "trap"}})));
  const Plan plan = problem.Find({"At(a)"});
  EXPECT_NEAR(plan.probability, 0.9, 1e-12);
  EXPECT_NEAR(plan.expected_actions, 2, 1e-9);
  EXPECT_EQ(problem.Step(plan, 1), "Leave()");
}

TEST(PlanSearch, CountsActionsOnlyOfCoursesThatReachTheGoal) {
  // With .5 each: one action to g, or b, from where .2 reach g and the rest
  // the trap. P = .6; E = (.5 * 1 + .1 * 2) / .6.
  Puzzle problem(Mdp(Edge("Throw", "a", {{0.5, "g"}, {0.5, "b"}}) +
                     Edge("Hope", "b", {{0.2, "g"}, {0.8, "trap"}})));
  const Plan plan = problem.Find({"At(a)"});
  EXPECT_NEAR(plan.probability, 0.6, 1e-12);
  EXPECT_NEAR(plan.expected_actions, 0.7 / 0.6, 1e-9);
}

TEST(PlanSearch, ADeadEndHasNoPlan) {
  Puzzle problem(Mdp(Edge("Leave", "b", {{1, "g"}})));
  const Plan plan = problem.Find({"At(trap)"});
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  EXPECT_EQ(plan.probability, 0);
  EXPECT_TRUE(plan.steps.empty());
  EXPECT_THAT(plan.reason, HasSubstr("cannot be reached: At(g)"));
}

TEST(PlanSearch, TheGoalIsReachedWithoutSteps) {
  Puzzle problem(Mdp(Edge("Leave", "g", {{1, "a"}})));
  const Plan plan = problem.Find({"At(g)"});
  EXPECT_EQ(plan.result, Plan::Result::kGoalReached);
  EXPECT_EQ(plan.probability, 1);
  EXPECT_EQ(plan.expected_actions, 0);
  EXPECT_TRUE(plan.steps.empty());
}

TEST(PlanSearch, MoreStatesThanAllowedIsAReasonAndNoHang) {
  std::string text = "types: {lamp: object}\nconstants: {";
  for (int i = 0; i < 20; ++i) text += "l" + std::to_string(i) + ": lamp, ";
  text +=
      "z: lamp}\npredicates: {On: {arguments: [lamp]}}\nactions:\n  Switch:\n"
      "    arguments: {X: lamp}\n    rules:\n"
      "      - {context: [not On(X)], noise: 0,"
      " outcomes: [{probability: 1, effects: [On(X)]}]}\n"
      "goals: {done: [On(z)]}\n";
  Puzzle problem(text, 1000);
  const Plan plan = problem.Find({});
  EXPECT_EQ(plan.result, Plan::Result::kUndecided);
  EXPECT_THAT(plan.reason, HasSubstr("more than 1000 states"));
  EXPECT_EQ(problem.search().num_states(), 0);
}

// IPPC-2008 triangle-tireworld p01 as rules: known values 1 and 6.25.
TEST(PlanSearch, TriangleTireworldHasItsKnownValues) {
  Puzzle problem(R"yaml(
types: {location: object}
constants: {l11: location, l12: location, l13: location, l21: location,
            l22: location, l31: location}
static_facts:
  road: {arguments: [location, location],
         facts: [[l11, l12], [l12, l13], [l11, l21], [l12, l22], [l21, l12],
                 [l22, l13], [l21, l31], [l31, l22]]}
predicates:
  VehicleAt: {arguments: [location]}
  SpareIn: {arguments: [location]}
  FlatTire: {arguments: []}
  HasSpare: {arguments: []}
actions:
  Move:
    arguments: {X: location, Y: location}
    rules:
      - context: [VehicleAt(X), "road(X, Y)", not FlatTire()]
        outcomes:
          - {probability: 0.5,
             effects: [VehicleAt(Y), not VehicleAt(X), FlatTire()]}
          - {probability: 0.5, effects: [VehicleAt(Y), not VehicleAt(X)]}
        noise: 0
  Load:
    arguments: {X: location}
    rules:
      - context: [VehicleAt(X), SpareIn(X)]
        outcomes:
          - {probability: 1, effects: [not SpareIn(X), HasSpare()]}
        noise: 0
  Change:
    arguments: {}
    rules:
      - context: [HasSpare()]
        outcomes:
          - {probability: 1, effects: [not HasSpare(), not FlatTire()]}
        noise: 0
goals: {done: [VehicleAt(l13)]}
)yaml");
  const Plan plan = problem.Find(
      {"VehicleAt(l11)", "SpareIn(l21)", "SpareIn(l22)", "SpareIn(l31)"});
  EXPECT_NEAR(plan.probability, 1, 1e-9);
  EXPECT_NEAR(plan.expected_actions, 6.25, 1e-9);
}

// A tower of two with blocks that may explode under what is put on them.
TEST(PlanSearch, ExplodingBlocksGiveTheBestRisk) {
  Puzzle problem(R"yaml(
types: {block: object}
constants: {a: block, b: block}
predicates:
  On: {arguments: [block, block]}
  Intact: {arguments: [block]}
actions:
  Stack:
    arguments: {X: block, Y: block}
    rules:
      - context: ["not On(X, _)", "not On(_, X)", "not On(_, Y)", Intact(X),
                  Intact(Y)]
        outcomes:
          - {probability: 0.9, effects: ["On(X, Y)"]}
          - {probability: 0.1, effects: ["On(X, Y)", not Intact(Y)]}
        noise: 0
  Unstack:
    arguments: {X: block, Y: block}
    rules:
      - context: ["On(X, Y)", "not On(_, X)"]
        outcomes: [{probability: 1, effects: ["not On(X, Y)"]}]
        noise: 0
goals: {done: ["On(a, b)", Intact(b)]}
)yaml");
  const Plan plan = problem.Find({"On(b, a)", "Intact(a)", "Intact(b)"});
  EXPECT_NEAR(plan.probability, 0.9, 1e-12);
  EXPECT_NEAR(plan.expected_actions, 2, 1e-9);
}

constexpr char kDoor[] = R"yaml(
types: {room: object}
constants: {hall: room, study: room}
predicates:
  In: {arguments: [room]}
  Unlocked: {arguments: [room]}
  Dark: {arguments: [room]}
actions:
  Enter:
    arguments: {X: room}
    rules:
      - context: [Unlocked(X), not Dark(X), not In(X)]
        outcomes: [{probability: 1, effects: [In(X)]}]
        noise: 0
goals: {done: [In(study)]}
)yaml";

TEST(PlanSearch, SaysWhichPreconditionNothingMakesTrue) {
  Puzzle problem(kDoor);
  const Plan plan = problem.Find({"In(hall)"});
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  EXPECT_EQ(plan.reason,
            "cannot be reached: In(study); Enter(study) needs "
            "Unlocked(study), but Unlocked(study) is false and no action "
            "makes it true");
}

TEST(PlanSearch, NamesEveryPreconditionThatIsMissing) {
  Puzzle problem(kDoor);
  const Plan plan = problem.Find({"In(hall)", "Dark(study)"});
  EXPECT_THAT(plan.reason, HasSubstr("Unlocked(study) is false"));
  EXPECT_THAT(plan.reason,
              HasSubstr("needs not Dark(study), but Dark(study) is true and "
                        "no action makes it false"));
  EXPECT_THAT(plan.reason, testing::Not(HasSubstr("hall")));
}

// To flip all at once would raise the alarm, which nobody can call off.
TEST(PlanSearch, NamesWhatConcernsOneObjectWhereFlippingAllIsNoWay) {
  std::string text = kDoor;
  text.replace(text.find("  Dark:"), 0, "  Alarm: {arguments: [room]}\n");
  text.replace(text.find("not In(X)"), 0, "not Alarm(hall), ");
  text.replace(text.find("goals:"), 0,
               "  Answer:\n    arguments: {}\n    rules:\n"
               "      - context: [Alarm(hall)]\n"
               "        outcomes: [{probability: 1, effects: [In(hall)]}]\n"
               "        noise: 0\n");
  Puzzle problem(text);
  const Plan plan = problem.Find({"In(hall)", "Dark(study)"});
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  ASSERT_EQ(plan.needed.size(), 2U) << plan.reason;
  EXPECT_THAT(plan.reason, HasSubstr("Unlocked(study) is false"));
  EXPECT_THAT(plan.reason, HasSubstr("Dark(study) is true"));
}

constexpr char kBolts[] =
    "types: {bolt: object, hole: object}\n"
    "constants: {bolt_1: bolt, bolt_2: bolt, hole_1: hole, hole_2: hole}\n"
    "predicates:\n"
    "  In: {arguments: [bolt, hole]}\n"
    "  Clear: {arguments: [bolt]}\n"
    "actions:\n"
    "  Insert:\n"
    "    arguments: {X: bolt, Y: hole}\n"
    "    rules:\n"
    "      - context: [Clear(X), \"not In(X, _)\", \"not In(_, Y)\"]\n"
    "        outcomes: [{probability: 1, effects: [\"In(X, Y)\"]}]\n"
    "        noise: 0\n"
    "goals: {done: [\"In(bolt_1, hole_2)\", \"In(bolt_2, hole_1)\"]}\n";

TEST(PlanSearch, AsksToUndoWhatExcludesTheGoal) {
  Puzzle problem(kBolts);
  State state =
      problem.With({"Clear(bolt_1)", "Clear(bolt_2)", "In(bolt_1, hole_1)"});
  const Plan plan = problem.search().Find(state);
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  ASSERT_EQ(plan.needed.size(), 1U) << plan.reason;
  EXPECT_EQ(plan.needed[0].truth, Truth::kFalse);
  EXPECT_THAT(plan.reason, HasSubstr("not In(bolt_1, hole_1)"));
}

TEST(PlanSearch, AsksToUndoNothingWhereSomethingElseHelps) {
  Puzzle problem(kBolts);
  const Plan plan = problem.Find({"Clear(bolt_1)", "In(bolt_1, hole_2)"});
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  ASSERT_EQ(plan.needed.size(), 1U) << plan.reason;
  EXPECT_THAT(plan.reason, HasSubstr("needs Clear(bolt_2)"));
}

TEST(PlanSearch, WhatIsUnknownLeavesThePlanUndecidedOnlyIfItMatters) {
  Puzzle problem(kDoor);
  State state = problem.With({"In(hall)"});
  problem.Set(state, "Unlocked(study)", Truth::kUnknown);
  const Plan undecided = problem.search().Find(state);
  EXPECT_EQ(undecided.result, Plan::Result::kUndecided);
  EXPECT_THAT(undecided.reason, HasSubstr("Unlocked(study)"));

  problem.Set(state, "Dark(study)", Truth::kTrue);
  EXPECT_EQ(problem.search().Find(state).result, Plan::Result::kNoPlan);

  problem.Set(state, "Unlocked(study)", Truth::kTrue);
  problem.Set(state, "Dark(study)", Truth::kFalse);
  problem.Set(state, "Unlocked(hall)", Truth::kUnknown);
  EXPECT_EQ(problem.search().Find(state).result, Plan::Result::kFound);
}

TEST(PlanSearch, AGoalThatIsUnknownIsNotReached) {
  Puzzle problem(kDoor);
  State state = problem.With({"In(hall)"});
  problem.Set(state, "In(study)", Truth::kUnknown);
  EXPECT_EQ(problem.search().Find(state).result, Plan::Result::kUndecided);
}

TEST(PlanSearch, AnswersDoNotDependOnEarlierQuestions) {
  const std::string text = Mdp(Edge("Walk", "a", {{0.3, "b"}, {0.3, "c"}}) +
                               Edge("Back", "c", {{0.7, "a"}}) +
                               Edge("Leave", "b", {{0.9, "g"}, {0.1, "a"}}));
  Puzzle fresh(text);
  Puzzle used(text);
  used.Find({"At(c)"});
  used.Find({"At(b)"});
  EXPECT_EQ(fresh.Find({"At(a)"}), used.Find({"At(a)"}));
}

}  // namespace
}  // namespace cell
