// What the planner learns from experiences while it runs, and what the robot
// does with it.
#include "services/planner/exploration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planner/plan_search.h"
#include "services/planner/rule_alternatives.h"
#include "services/planner/unlearned.h"
#include "tests/unit/planner/learning_bench.h"

namespace cell {

using namespace planner;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ExplorationTest : public testing::Test {
 protected:
  CurrentPlan PlanOf(const State& state) const {
    CurrentPlan plan(bench_.rules, bench_.bench.GoalOf("done"),
                     PlanSearch::Maker({}));
    plan.Find(state, {});
    return plan;
  }
  std::string Step(const State& state) const {
    const auto step =
        StepWithoutPlan(PlanOf(state), state, {}, bench_.Exploring());
    return step ? bench_.rules->Show(*step) : "";
  }
  std::vector<std::string> Names(const std::vector<Literal>& literals) const {
    std::vector<std::string> names;
    for (const Literal& literal : literals) {
      names.push_back(Show(literal, {}, bench_.rules->vocabulary()));
    }
    return names;
  }

  LearningBench bench_;
};

TEST_F(ExplorationTest, WhatNoRuleBringsAboutIsNotLearned) {
  const State start = bench_.Start();
  const Plan plan = PlanOf(start).get();
  EXPECT_EQ(plan.result, Plan::Result::kNotLearned);
  EXPECT_THAT(
      Names(plan.unlearned),
      ElementsAre("In(_, box.hole_1)", "In(_, box.hole_2)", "Closed(lid)"));
  EXPECT_THAT(plan.reason, HasSubstr("no action is known after which"));
}

TEST_F(ExplorationTest, WhatHoldsAlreadyNeedsNoRule) {
  const State state = bench_.Start({"In(bolt_1, box.hole_1)"});
  EXPECT_THAT(Names(PlanOf(state).get().unlearned),
              ElementsAre("In(_, box.hole_2)", "Closed(lid)"));
}

TEST_F(ExplorationTest, OneShowingMakesARuleThatIsNotKnownYet) {
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", bench_.Start()));
  const Action& action =
      *std::ranges::find(bench_.rules->actions(), "Insert", &Action::name);
  ASSERT_FALSE(action.rules.empty());
  for (const NdrRule& rule : action.rules) EXPECT_EQ(rule.num_experiences, 1);
  EXPECT_THAT(Names(PlanOf(bench_.Start()).get().unlearned),
              ElementsAre("Closed(lid)"));
}

TEST_F(ExplorationTest, TriesWhatItsRuleKnowsLeastAndNoMoreOnceItIsKnown) {
  const State start = bench_.Start();
  EXPECT_FALSE(LeastTried(*bench_.rules, start, {}, 2));
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", start));
  const auto tried = LeastTried(*bench_.rules, start, {}, 2);
  ASSERT_TRUE(tried);
  EXPECT_THAT(bench_.rules->Show(*tried), HasSubstr("Insert("));
  EXPECT_NE(LeastTried(*bench_.rules, start, {*tried}, 2), tried);
  bench_.Learn(bench_.Inserted("bolt_2", "box.hole_2", start));
  EXPECT_FALSE(LeastTried(*bench_.rules, start, {}, 2));
}

TEST_F(ExplorationTest, DoesSubgoalsThatDoNotDependOnWhatIsNotLearned) {
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", bench_.Start()));
  EXPECT_THAT(Step(bench_.Start()), HasSubstr("Insert("));
}

// The rule from one showing says that no hole was filled. That is dropped, as
// it names no object of the action; that the bolt is free is not.
TEST_F(ExplorationTest, TriesARuleAlternativeWhereConditionsOfOthersFail) {
  const State start = bench_.Start();
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", start));
  const State one = bench_.With(start, "In(bolt_1, box.hole_1)");
  EXPECT_THAT(Step(one), HasSubstr("box.hole_2)"));
  const State covered_3 = bench_.With(one, "Clear(bolt_3)", false);
  bench_.Learn(bench_.Experience("Insert", {"bolt_3", "box.hole_2"}, covered_3,
                                 covered_3));
  State covered = one;
  for (const char* bolt : {"bolt_2", "bolt_3"}) {
    covered = bench_.With(covered, std::string("Clear(") + bolt + ")", false);
  }
  EXPECT_EQ(Step(covered), "");
}

TEST_F(ExplorationTest, GivesUpAnAlternativeThatExperiencesSpeakAgainst) {
  const State start = bench_.Start();
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", start));
  const State one = bench_.With(start, "In(bolt_1, box.hole_1)");
  const auto before =
      AlternativesIn(*bench_.rules, one, *bench_.knowledge.experiences(), 2);
  ASSERT_FALSE(before.empty());
  for (int i = 0; i < 2; ++i) {
    bench_.Learn(
        bench_.Experience("Insert", {"bolt_2", "box.hole_2"}, one, one));
  }
  EXPECT_EQ(Step(one), "");
}

TEST_F(ExplorationTest, ASuccessGeneralisesTheRule) {
  const State start = bench_.Start();
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", start));
  const State one = bench_.With(start, "In(bolt_1, box.hole_1)");
  bench_.Learn(bench_.Inserted("bolt_2", "box.hole_2", one));
  CurrentPlan plan(bench_.rules,
                   {"second", {bench_.bench.GoalOf("done").literals[1]}},
                   PlanSearch::Maker({}));
  for (const State& state : {start, one}) {
    EXPECT_EQ(plan.Find(state, {}).result, Plan::Result::kFound);
  }
}

TEST_F(ExplorationTest, WhatDependsOnTheUnlearnedIsNoSubgoal) {
  const State start = bench_.Start();
  const State both = bench_.With(bench_.With(start, "In(bolt_1, box.hole_1)"),
                                 "In(bolt_2, box.hole_2)");
  bench_.Learn(bench_.Experience("Close", {"lid"}, both,
                                 bench_.With(both, "Closed(lid)")));
  bench_.Learn(bench_.Experience("Close", {"lid"}, start, start));
  const CurrentPlan plan = PlanOf(start);
  EXPECT_THAT(Names(plan.get().unlearned), SizeIs(2));
  const Goal subgoals = Subgoals(plan.problem(), start, plan.get().unlearned);
  EXPECT_THAT(Names(subgoals.literals), IsEmpty());
  EXPECT_EQ(Step(start), "");
}

TEST_F(ExplorationTest, ExperiencesOfUnknownActionsWaitForTheirRecord) {
  bench_.Learn(
      bench_.Experience("Polish", {"lid"}, bench_.Start(), bench_.Start()));
  EXPECT_THAT(*bench_.knowledge.experiences(), SizeIs(1));
  ActionRecord record;
  record.id = 1;
  record.name = "Polish";
  record.arguments = {{"X", "lid"}};
  record.agents = {"person"};
  record.rules =
      "- {context: [Clear(X)], outcomes: [{probability: 0.9, effects: "
      "[Closed(X)]}], noise: 0.1}";
  bench_.knowledge.Put(record);
  const auto rules = bench_.knowledge.TakeChange(100);
  ASSERT_NE(rules, nullptr);
  EXPECT_EQ(rules->actions().back().name, "Polish");
}

TEST_F(ExplorationTest, AnExperienceCountsOnce) {
  const auto experience =
      bench_.Inserted("bolt_1", "box.hole_1", bench_.Start());
  bench_.knowledge.Add(7, experience);
  bench_.knowledge.Add(7, experience);
  EXPECT_NE(bench_.knowledge.TakeChange(2), nullptr);
  EXPECT_THAT(*bench_.knowledge.experiences(), SizeIs(1));
  EXPECT_EQ(bench_.knowledge.TakeChange(3), nullptr);
}

TEST_F(ExplorationTest, AnExperienceThatTheLibraryRemovesIsForgotten) {
  bench_.Learn(bench_.Inserted("bolt_1", "box.hole_1", bench_.Start()));
  bench_.knowledge.Remove(bench_.num_experiences + 1);  // there is none
  EXPECT_EQ(bench_.knowledge.TakeChange(100), nullptr);
  bench_.knowledge.Remove(bench_.num_experiences);
  EXPECT_NE(bench_.knowledge.TakeChange(101), nullptr);
  EXPECT_THAT(*bench_.knowledge.experiences(), IsEmpty());
}

TEST_F(ExplorationTest, WhoDoesNotLearnKeepsNoExperience) {
  Knowledge knowledge(bench_.bench.domain, false);
  knowledge.Add(1, bench_.Inserted("bolt_1", "box.hole_1", bench_.Start()));
  EXPECT_EQ(knowledge.TakeChange(2), nullptr);
}

}  // namespace
}  // namespace cell
