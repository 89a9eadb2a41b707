// What the shipped cell plans with the rules that it has learned.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/unit/cranfield_domain.h"

namespace cell {
namespace {

class LearnedRulesPlanning : public testing::Test {
 protected:
  Plan PlanFrom(const State& state, Agent agent = Agent::kPerson) const {
    PlanSearch search(
        {learned_, *cranfield_.domain->FindGoal("assembled"), agent}, {});
    return search.Find(state);
  }
  /// With all holes covered that the part covers, as it is sensed.
  State EarlyAt(const std::vector<std::string>& placed,
                const std::vector<std::string>& covered) const {
    return cranfield_.With(cranfield_.With(cranfield_.Start(), placed), covered,
                           Truth::kFalse);
  }

  Cranfield cranfield_;
  std::shared_ptr<const RuleSet> learned_ =
      RuleSet::FromDomain(LoadTask(cranfield_.deployment).domain);
};

TEST_F(LearnedRulesPlanning, NineStepsFromTheStartForPersonAndRobot) {
  const Plan of_person = PlanFrom(cranfield_.Start());
  const Plan of_robot =
      PlanFrom(cranfield_.StartWithin("right"), Agent::kRobot);
  for (const Plan& plan : {of_person, of_robot}) {
    EXPECT_EQ(plan.result, Plan::Result::kFound) << plan.reason;
    ASSERT_EQ(plan.steps.size(), 9U);
    EXPECT_EQ(learned_->Show(plan.steps.back().action),
              "PlaceFacePlate(face_plate)");
  }
}

TEST_F(LearnedRulesPlanning, WhatTheAuthorWouldDoNextIsPartOfThePlan) {
  std::mt19937_64 random(4);
  for (int run = 0; run < 10; ++run) {
    State state = cranfield_.Start();
    size_t num_left = 9;
    for (const GroundAction& action : cranfield_.RandomOrder(random)) {
      state = cranfield_.Do(state, action);
      EXPECT_EQ(PlanFrom(state).steps.size(), --num_left)
          << learned_->Show(action);
    }
  }
}

// The monitor warns: what lies too early must come off again.
TEST_F(LearnedRulesPlanning, APartThatIsPlacedTooEarlyMakesThePlanLonger) {
  const std::vector<std::string> square = {"Free(base.square_1)",
                                           "Free(base.square_2)"};
  const std::vector<std::string> shaft = {"Free(base.shaft)"};
  std::vector<std::string> all = {"Free(base.round_1)", "Free(base.round_2)"};
  all.insert(all.end(), square.begin(), square.end());
  all.insert(all.end(), shaft.begin(), shaft.end());
  for (const State& state : {EarlyAt({"SeparatorPlaced(separator)"}, square),
                             EarlyAt({"PendulumPlaced(pendulum)"}, shaft)}) {
    const Plan plan = PlanFrom(state);
    EXPECT_EQ(plan.result, Plan::Result::kFound) << plan.reason;
    EXPECT_EQ(plan.steps.size(), 10U);  // one off, then all nine
  }
  // On an empty base the face plate finds no hold.
  all.push_back("Clear(round_peg_1)");
  const Plan plan = PlanFrom(EarlyAt({"FacePlateFrontPlaced(face_plate)",
                                      "PegInHole(round_peg_1, base.round_2)"},
                                     all));
  EXPECT_EQ(plan.result, Plan::Result::kFound) << plan.reason;
  EXPECT_EQ(plan.steps.size(), 9U);  // one off, then the other eight
}

// The monitor says that there is no plan, and what is needed.
TEST_F(LearnedRulesPlanning, APartOutOfReachLeavesNoPlan) {
  for (const char* part : {"round_peg_1", "square_peg_2", "shaft"}) {
    const int clear = cranfield_.Atom("Clear(" + std::string(part) + ")");
    State state = cranfield_.Start();
    state.Set(clear, Truth::kFalse);
    const Plan plan = PlanFrom(state);
    EXPECT_EQ(plan.result, Plan::Result::kNoPlan) << part;
    ASSERT_EQ(plan.needed.size(), 1U) << part;
    EXPECT_EQ(plan.needed[0].atom, clear) << plan.reason;
  }
}

TEST_F(LearnedRulesPlanning, TheRobotNamesThePartThatIsGone) {
  for (const char* part : {"round_peg_1", "square_peg_2", "shaft", "separator",
                           "pendulum", "head", "face_plate"}) {
    State state = cranfield_.StartWithin("right");
    const std::string name = part;
    for (const std::string& atom :
         {"Clear(" + name + ")", "Reachable(right, " + name + ")"}) {
      state.Set(cranfield_.Atom(atom), Truth::kFalse);
    }
    const Plan plan = PlanFrom(state, Agent::kRobot);
    EXPECT_EQ(plan.result, Plan::Result::kNoPlan) << part;
    EXPECT_FALSE(plan.needed.empty()) << part << ": " << plan.reason;
    for (const RequiredChange& needed : plan.needed) {
      EXPECT_THAT(cranfield_.rules->vocabulary().AtomName(needed.atom),
                  testing::HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace cell
