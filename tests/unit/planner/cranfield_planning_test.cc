#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/unit/cranfield_domain.h"

namespace cell {
namespace {

using testing::HasSubstr;

constexpr double kPerAction = 1 / 0.95;  // expected tries of an action

class CranfieldPlanning : public testing::Test {
 protected:
  Cranfield cranfield_;
  PlanSearch search_ = cranfield_.Search();
};

TEST_F(CranfieldPlanning, NinePlacementsFromTheStart) {
  const Plan plan = search_.Find(cranfield_.Start());
  EXPECT_EQ(plan.result, Plan::Result::kFound);
  EXPECT_NEAR(plan.probability, 1, 1e-9);
  EXPECT_NEAR(plan.expected_actions, 9 * kPerAction, 1e-8);
  ASSERT_EQ(plan.steps.size(), 9u);
  EXPECT_EQ(cranfield_.domain->Show(plan.steps[8].action),
            "PlaceFacePlate(face_plate)");
  RecordProperty("states", search_.num_states());
}

// Two round pegs in two holes, two square ones in two, and the shaft.
TEST_F(CranfieldPlanning, AnyPegMayComeFirst) {
  const Plan plan = search_.Find(cranfield_.Start());
  ASSERT_EQ(plan.next.size(), 9u);
  for (const PlanStep& step : plan.next) {
    EXPECT_NEAR(step.expected_actions, 9 * kPerAction, 1e-8);
    EXPECT_NEAR(step.probability, 0.95, 1e-12);
  }
}

TEST_F(CranfieldPlanning, EveryStepOfEveryOrderShortensThePlanByOne) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 50; ++run) {
    State state = cranfield_.Start();
    const auto order = cranfield_.RandomOrder(random);
    ASSERT_EQ(order.size(), 9u);
    for (size_t i = 0; i < order.size(); ++i) {
      state = cranfield_.Do(state, order[i]);
      const double left = static_cast<double>(order.size() - i - 1);
      EXPECT_NEAR(search_.Find(state).expected_actions, left * kPerAction,
                  1e-8);
    }
    EXPECT_EQ(search_.Find(state).result, Plan::Result::kGoalReached);
  }
}

// Placed too early the separator has to come off again: two actions more than
// after a right step. Its holes are sensed as covered.
TEST_F(CranfieldPlanning, TheSeparatorBeforeThePegsCostsTwoActions) {
  State state =
      cranfield_.With(cranfield_.Start(), {"SeparatorPlaced(separator)"});
  const double covered_not_sensed = search_.Find(state).expected_actions;
  state = cranfield_.With(state, {"Free(base.square_1)", "Free(base.square_2)"},
                          Truth::kFalse);
  const Plan plan = search_.Find(state);
  EXPECT_NEAR(plan.expected_actions, 10 * kPerAction, 1e-8);
  EXPECT_NEAR(covered_not_sensed, 10 * kPerAction, 1e-8);
}

TEST_F(CranfieldPlanning, ThePendulumBeforeTheShaftCostsTwoActions) {
  const State state = cranfield_.With(
      cranfield_.With(cranfield_.Start(), {"PendulumPlaced(pendulum)"}),
      {"Free(base.shaft)"}, Truth::kFalse);
  EXPECT_NEAR(search_.Find(state).expected_actions, 10 * kPerAction, 1e-8);
}

TEST_F(CranfieldPlanning, TheFacePlateTooEarlyComesOffAgain) {
  State state =
      cranfield_.With(cranfield_.Start(), {"FacePlateFrontPlaced(face_plate)"});
  for (const char* hole :
       {"round_1", "round_2", "square_1", "square_2", "shaft"}) {
    state = cranfield_.With(state, {std::string("Free(base.") + hole + ")"},
                            Truth::kFalse);
  }
  EXPECT_NEAR(search_.Find(state).expected_actions, 10 * kPerAction, 1e-8);
}

TEST_F(CranfieldPlanning, ALyingPegIsRaisedFirst) {
  const State state =
      cranfield_.With(cranfield_.Start(), {"Horizontal(round_peg_2)"});
  EXPECT_NEAR(search_.Find(state).expected_actions, 10 * kPerAction, 1e-8);
}

TEST_F(CranfieldPlanning, APegOutOfReachLeavesNoPlanAndIsNamed) {
  const State state = cranfield_.With(cranfield_.Start(),
                                      {"Clear(round_peg_1)"}, Truth::kFalse);
  const Plan plan = search_.Find(state);
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  EXPECT_EQ(plan.probability, 0);
  EXPECT_THAT(plan.reason, HasSubstr("Clear(round_peg_1) is false and no "
                                     "action makes it true"));
  EXPECT_THAT(plan.reason, HasSubstr("FacePlateFrontPlaced(face_plate)"));
  EXPECT_THAT(plan.reason, testing::Not(HasSubstr("Clear(round_peg_2)")));
}

TEST_F(CranfieldPlanning, EveryPartOutOfReachIsNamedAtAnyStage) {
  std::mt19937_64 random(2);
  for (const char* part : {"round_peg_2", "square_peg_1", "shaft", "separator",
                           "pendulum", "head", "face_plate"}) {
    State state = cranfield_.Start();
    const std::string clear = std::string("Clear(") + part + ")";
    state.Set(cranfield_.Atom(clear), Truth::kFalse);
    for (auto all = cranfield_.Placements(state); !all.empty();
         all = cranfield_.Placements(state)) {
      const Plan plan = search_.Find(state);
      EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
      EXPECT_THAT(plan.reason, HasSubstr(clear + " is false and no action"));
      state = cranfield_.Do(state, all[random() % all.size()]);
    }
  }
}

TEST_F(CranfieldPlanning, ASpareIdenticalPegIsNoObstacle) {
  State state = cranfield_.Do(cranfield_.Start(), "PlaceRoundPeg",
                              {"round_peg_2", "base.round_1"});
  EXPECT_NEAR(search_.Find(state).expected_actions, 8 * kPerAction, 1e-8);
  state =
      cranfield_.Do(state, "PlaceRoundPeg", {"round_peg_1", "base.round_2"});
  EXPECT_NEAR(search_.Find(state).expected_actions, 7 * kPerAction, 1e-8);
}

TEST_F(CranfieldPlanning, OneUnknownPlacementIsUndecidedOnlyIfItMatters) {
  State state = cranfield_.Start();
  state.Set(cranfield_.Atom("Clear(head)"), Truth::kUnknown);
  EXPECT_EQ(search_.Find(state).result, Plan::Result::kUndecided);
  state.Set(cranfield_.Atom("Clear(head)"), Truth::kTrue);
  state.Set(cranfield_.Atom("Horizontal(shaft)"), Truth::kUnknown);
  EXPECT_EQ(search_.Find(state).result, Plan::Result::kFound);
}

class CranfieldRobot : public CranfieldPlanning {
 protected:
  Plan Find(const State& state) { return robot_.Find(state); }
  std::vector<std::string> Steps(const Plan& plan) const {
    std::vector<std::string> steps;
    for (const PlanStep& step : plan.steps) {
      steps.push_back(cranfield_.domain->Show(step.action));
    }
    return steps;
  }

  State start_ = cranfield_.StartWithin("right");
  PlanSearch robot_{cranfield_.ProblemOf(Agent::kRobot), {}};
};

TEST_F(CranfieldRobot, PlacesNinePartsThatTheInsertingArmReaches) {
  const Plan plan = Find(start_);
  EXPECT_EQ(plan.result, Plan::Result::kFound);
  EXPECT_NEAR(plan.expected_actions, 9 * kPerAction, 1e-8);
  EXPECT_EQ(plan.steps.size(), 9u);
  EXPECT_LT(robot_.num_states(), 1000);
  RecordProperty("states", robot_.num_states());
}

TEST_F(CranfieldRobot, PassesOnWhatOnlyTheOtherArmReaches) {
  const State state =
      cranfield_.With(cranfield_.With(start_, {"Reachable(left, pendulum)"}),
                      {"Reachable(right, pendulum)"}, Truth::kFalse);
  const Plan plan = Find(state);
  EXPECT_NEAR(plan.expected_actions, 10 * kPerAction, 1e-8);
  EXPECT_THAT(Steps(plan), testing::Contains("Present(pendulum)"));
}

TEST_F(CranfieldRobot, PassesOnEveryPartWithinTheStatesAllowed) {
  const Plan plan = Find(cranfield_.StartWithin("left"));
  EXPECT_NEAR(plan.expected_actions, 18 * kPerAction, 1e-8);
  RecordProperty("states", robot_.num_states());
  EXPECT_LT(robot_.num_states(), 100'000);
}

TEST_F(CranfieldRobot, PlacesWhatItHoldsOrMakesRoom) {
  Plan plan = Find(cranfield_.With(start_, {"Held(shaft, right)"}));
  EXPECT_NEAR(plan.expected_actions, 9 * kPerAction, 1e-8);
  EXPECT_EQ(Steps(plan)[0], "PlaceRoundPeg(shaft, base.shaft)");
  plan = Find(cranfield_.With(start_, {"Held(head, right)"}));
  EXPECT_NEAR(plan.expected_actions, 10 * kPerAction, 1e-8);
  EXPECT_EQ(Steps(plan)[0], "PutDown(head, right)");
  State state = cranfield_.With(start_, {"Held(head, left)"});
  state = cranfield_.With(state, {"Reachable(right, head)"}, Truth::kFalse);
  plan = Find(state);
  EXPECT_NEAR(plan.expected_actions, 10 * kPerAction, 1e-8);
  EXPECT_THAT(Steps(plan), testing::Contains("Present(head)"));
}

TEST_F(CranfieldRobot, AsksForAPartThatNoArmReaches) {
  const Plan plan = Find(
      cranfield_.With(start_, {"Reachable(right, separator)"}, Truth::kFalse));
  EXPECT_EQ(plan.result, Plan::Result::kNoPlan);
  ASSERT_EQ(plan.needed.size(), 1u);
  // In reach of the left arm it would have to be presented first.
  EXPECT_EQ(plan.needed[0].atom,
            cranfield_.Atom("Reachable(right, separator)"));
  EXPECT_EQ(plan.needed[0].truth, Truth::kTrue);
  EXPECT_THAT(plan.needed[0].why,
              testing::HasSubstr("PlaceSeparator(separator)"));
}

TEST_F(CranfieldRobot, TakesNothingOff) {
  EXPECT_EQ(
      Find(cranfield_.With(start_, {"SeparatorPlaced(separator)"})).result,
      Plan::Result::kNoPlan);
}

TEST_F(CranfieldRobot, KnowsHowAnArmDoesEachOfItsActions) {
  const Domain& domain = *cranfield_.domain;
  const Vocabulary& v = domain.vocabulary();
  for (const GroundAction& action : domain.GroundActions(Agent::kRobot)) {
    const auto skill = domain.SkillOf(action);
    ASSERT_TRUE(skill.has_value()) << domain.Show(action);
    EXPECT_EQ(skill->arguments.at("part"), action.arguments[0]);
    EXPECT_TRUE(v.IsOf(skill->arm, *v.types().Find("arm")));
    if (skill->name != "insert") continue;
    EXPECT_EQ(v.objects()[skill->arm].name, "right");
    const int fits = *v.FindStatic("fits");
    EXPECT_TRUE(v.static_relations()[fits].facts.contains(
        {skill->arguments.at("part"), skill->arguments.at("site")}))
        << domain.Show(action);
  }
}

class CranfieldRules : public CranfieldPlanning {
 protected:
  /// What a person can bring about from the start, one action at a time.
  std::vector<State> ReachableStates() {
    StateSpace space(cranfield_.rules, Agent::kPerson);
    const State lying = cranfield_.With(
        cranfield_.Start(), {"Horizontal(shaft)", "Horizontal(square_peg_1)"});
    space.Enter(lying, 100'000);
    std::vector<State> states;
    for (int s = 0; s < space.size(); ++s) states.push_back(space.state(s));
    return states;
  }
};

TEST_F(CranfieldRules, RulesOfAnActionAreDisjoint) {
  for (const State& state : ReachableStates()) {
    for (const auto& action :
         cranfield_.domain->GroundActions(Agent::kPerson)) {
      ASSERT_LE(cranfield_.RulesFor(action, state).size(), 1u)
          << cranfield_.domain->Show(action);
    }
  }
}

TEST_F(CranfieldRules, ProbabilitiesSumToOne) {
  for (const Action& action : cranfield_.domain->actions()) {
    for (const NdrRule& rule : action.rules) {
      double sum = rule.noise;
      for (const Outcome& outcome : rule.outcomes) sum += outcome.probability;
      EXPECT_NEAR(sum, 1, 1e-12) << action.name;
    }
  }
}

// A peg is in one hole, a hole with a peg is not free, one without is; what
// lies under the face plate is not clear, all else is.
TEST_F(CranfieldRules, EffectsKeepStatesConsistent) {
  const Vocabulary& v = cranfield_.domain->vocabulary();
  const int in_hole = *v.FindPredicate("PegInHole");
  const int free = *v.FindPredicate("Free");
  const int covered = cranfield_.Atom("FacePlateFrontPlaced(face_plate)");
  for (const State& state : ReachableStates()) {
    for (const int peg : v.ObjectsOf(*v.types().Find("peg"))) {
      int num_holes = 0;
      for (const int hole : v.ObjectsOf(*v.types().Find("hole"))) {
        const std::vector<int> both = {peg, hole};
        num_holes += state.Get(*v.AtomIndex(in_hole, both)) == Truth::kTrue;
      }
      ASSERT_LE(num_holes, 1);
      const std::string clear = "Clear(" + v.objects()[peg].name + ")";
      ASSERT_EQ(state.Get(cranfield_.Atom(clear)) == Truth::kFalse,
                state.Get(covered) == Truth::kTrue && num_holes == 1);
    }
    for (const int hole : v.ObjectsOf(*v.types().Find("hole"))) {
      int num_pegs = 0;
      for (const int peg : v.ObjectsOf(*v.types().Find("peg"))) {
        const std::vector<int> both = {peg, hole};
        num_pegs += state.Get(*v.AtomIndex(in_hole, both)) == Truth::kTrue;
      }
      ASSERT_LE(num_pegs, 1);
      const std::vector<int> only = {hole};
      ASSERT_EQ(state.Get(*v.AtomIndex(free, only)) == Truth::kTrue,
                num_pegs == 0);
    }
  }
}

TEST_F(CranfieldRules, TakingBackRestoresTheState) {
  std::mt19937_64 random(3);
  for (int run = 0; run < 20; ++run) {
    State state = cranfield_.Start();
    for (const GroundAction& action : cranfield_.RandomOrder(random)) {
      const State after = cranfield_.Do(state, action);
      for (const GroundAction& back :
           cranfield_.domain->GroundActions(Agent::kPerson)) {
        const auto& undoes = cranfield_.domain->actions()[back.action].undoes;
        if (undoes != action.action || back.arguments != action.arguments) {
          continue;
        }
        EXPECT_EQ(cranfield_.Do(after, back), state)
            << cranfield_.domain->Show(back);
      }
      state = after;
    }
  }
}

}  // namespace
}  // namespace cell
