#include "common/rexd/rexd.h"

#include <gmock/gmock.h>

#include "common/rexd/rexd_run.h"
#include "common/rules/data_text.h"
#include "common/rules/rule_error.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;

class LearnerOfPlacing : public testing::Test {
 protected:
  GroundAct Act(const char* action, const char* object) const {
    return {*task_.world->symbols().Find(action),
            {*task_.world->FindObject(object)}};
  }
  /// What happens by the true rules; the learner sees it.
  WorldState Do(const GroundAct& act, const WorldState& before) {
    RandomNumbers random(1);
    const WorldState after =
        Simulate(task_.truth, *task_.world, act, before, &random);
    learner_.Observe({before, act, after});
    return after;
  }

  RexdTask task_ = PlacingTask();
  RexD learner_{task_, {}};
};

TEST(RexdTask, RefusesEffectsForEachObject) {
  try {
    ParseRexdTask(
        "objects: a\nstart:\ngoal: p(a)\np 1 primitive\nact 0 action\n\n"
        "Action: act()\nPreconditions:\nEffects:\n  1: nothing\n"
        "    each P: p(P)\n  0: noise\n",
        "t");
    ADD_FAILURE();
  } catch (const RuleError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("t:11: the rules of a task"));
  }
}

TEST(RexdTask, AnObjectIsNamedOnce) {
  try {
    ParseRexdTask("objects: a b a\nstart:\ngoal: p(a)\np 1 primitive\n", "t");
    ADD_FAILURE();
  } catch (const RuleError& error) {
    EXPECT_STREQ(error.what(), "t:1: 'a' is there twice");
  }
}

/// Of ParseChangedTask().
std::string ComplaintOf(const std::string& changes) {
  try {
    ParseChangedTask(PlacingTask(), changes, "c");
  } catch (const RuleError& error) {
    return error.what();
  }
  return "";
}

TEST(ChangedTask, DiffersOnlyInWhatItsTextSays) {
  const RexdTask task = PlacingTask();
  const RexdTask changed = ParseChangedTask(
      task, "# a comment\nchanges: placed(red) -book(blue)\n", "c");
  const auto expected =
      ParseState("book(red) cover(lid) placed(red)", "d", 1, *task.world);
  EXPECT_EQ(changed.initial.bits, expected.bits);
  EXPECT_EQ(changed.goal, task.goal);
  EXPECT_EQ(changed.world, task.world);

  const RexdTask other = ParseChangedTask(task, "goal: -placed(blue)", "c");
  EXPECT_EQ(other.initial, task.initial);
  EXPECT_TRUE(other.IsGoal(other.initial));
  EXPECT_FALSE(task.IsGoal(task.initial));
}

TEST(ChangedTask, NamesTheLineOfAMistake) {
  EXPECT_THAT(ComplaintOf("\nchanges: placed(green)"),
              testing::StartsWith("c:2:"));
  EXPECT_THAT(ComplaintOf("\nchanges: placed(green)"),
              testing::HasSubstr("there is no object 'green'"));
  EXPECT_THAT(ComplaintOf("changes: standing(red)"),
              testing::HasSubstr("there is no predicate 'standing'"));
  EXPECT_THAT(ComplaintOf("changes: placed(red lid)"),
              testing::HasSubstr("'placed' has 1 arguments, not 2"));
  EXPECT_THAT(ComplaintOf("goal: closed()\n\ngoal: closed()"),
              testing::AllOf(testing::StartsWith("c:3:"),
                             testing::HasSubstr("'goal:' is there twice")));
  EXPECT_THAT(ComplaintOf("goal:"), testing::HasSubstr("the goal is empty"));
  EXPECT_THAT(ComplaintOf("goal: placed(red) -placed(red)"),
              testing::HasSubstr("wants 'placed' to hold and not to hold"));
  EXPECT_THAT(ComplaintOf("start: closed()"),
              testing::AllOf(testing::StartsWith("c:1:"),
                             testing::HasSubstr("expected 'changes: ...'")));
}

TEST_F(LearnerOfPlacing, AsksWhenItKnowsNoAction) {
  EXPECT_EQ(learner_.Decide(task_.initial).kind, Decision::Kind::kAsk);
}

TEST_F(LearnerOfPlacing, ExploresAnActionThatItHasSeenOnce) {
  const WorldState state = Do(Act("place", "red"), task_.initial);
  const Decision decision = learner_.Decide(state);
  EXPECT_EQ(decision.kind, Decision::Kind::kExplore);
  EXPECT_EQ(decision.act.action, *task_.world->symbols().Find("place"));
}

TEST_F(LearnerOfPlacing, AsksInAKnownStateWithoutAPlan) {
  WorldState state = Do(Act("place", "red"), task_.initial);
  state = Do(Act("place", "blue"), state);
  state = Do(Act("place", "blue"), state);
  state = Do(Act("place", "red"), state);
  // Nothing that it knows closes the shelf.
  EXPECT_EQ(learner_.Decide(state).kind, Decision::Kind::kAsk);
}

TEST_F(LearnerOfPlacing, ExploitsWhenThereIsAPlanInAKnownState) {
  for (int episode = 0; episode < 2; ++episode) {
    WorldState state = Do(Act("place", "red"), task_.initial);
    state = Do(Act("place", "blue"), state);
    state = Do(Act("close", "lid"), state);
    Do(Act("close", "lid"), state);
    Do(Act("place", "red"), state);
  }
  const Decision decision = learner_.Decide(task_.initial);
  EXPECT_EQ(decision.kind, Decision::Kind::kExploit);
  EXPECT_EQ(decision.act.action, *task_.world->symbols().Find("place"));
}

TEST(RunRexd, LearnsATaskAndDoesItWithoutATeacherThen) {
  const RexdTask task = PlacingTask();
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    RunParams params;
    params.seed = seed;
    params.num_episodes = 4;
    const auto episodes = RunRexd(task, params);
    ASSERT_EQ(episodes.size(), 4u);
    EXPECT_GE(episodes[0].num_demonstrations, 2);
    EXPECT_TRUE(episodes[3].is_goal_reached) << seed;
    EXPECT_EQ(episodes[3].num_demonstrations, 0) << seed;
    EXPECT_EQ(episodes[3].num_actions, 3) << seed;
  }
}

TEST(RunRexdInTurn, NeedsNoTeacherForWhatWasLearnedInAnotherTask) {
  const RexdTask task = PlacingTask();
  const RexdTask easier = ParseChangedTask(task, "changes: placed(red)", "c");
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    RunParams params;
    params.seed = seed;
    const auto blocks = RunRexdInTurn({task, easier}, params);
    ASSERT_EQ(blocks.size(), 2u);
    const auto scratch = RunRexd(easier, params);
    EXPECT_EQ(blocks[0].front().num_actions,
              RunRexd(task, params).front().num_actions);
    EXPECT_EQ(blocks[1].front().num_demonstrations, 0) << seed;
    EXPECT_GT(scratch.front().num_demonstrations, 0) << seed;
    EXPECT_TRUE(blocks[1].back().is_goal_reached) << seed;
  }
}

TEST(RunRexdInTurn, RefusesTasksOfAnotherWorld) {
  const RexdTask task = PlacingTask();
  const RexdTask other = PlacingTask();
  EXPECT_THROW(RunRexdInTurn({task, other}, {}), std::invalid_argument);
  EXPECT_THROW(RunRexdInTurn({}, {}), std::invalid_argument);
}

TEST(RunRexd, EqualSeedsGiveEqualRuns) {
  const RexdTask task = PlacingTask();
  RunParams params;
  params.success = 0.5;
  params.teacher.is_sure = false;
  const auto first = RunRexd(task, params);
  const auto second = RunRexd(task, params);
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].num_actions, second[i].num_actions);
    EXPECT_EQ(first[i].num_explorations, second[i].num_explorations);
  }
}

// A quick way across may break the cup for ever; the slow one does not.
constexpr char kCupTask[] = R"(
objects: cup
start: here(cup)
goal: there(cup)
here 1 primitive
half 1 primitive
there 1 primitive
broken 1 primitive
throwIt 1 action
carry 1 action

Action: throwIt(X)
Preconditions: here(X), not broken(X)
Effects:
  0.5: not here(X), there(X)
  0.5: not here(X), broken(X)
  0: noise

Action: carry(X)
Preconditions: here(X)
Effects:
  1: not here(X), half(X)
  0: noise

Action: carry(X)
Preconditions: half(X)
Effects:
  1: not half(X), there(X)
  0: noise
)";

TEST(RexDDeadEnd, IsNotEnteredAgain) {
  const RexdTask task = ParseRexdTask(kCupTask, "t");
  const auto state = [&](const char* text) {
    return ParseState(text, "d", 1, *task.world);
  };
  const GroundAct thrown{*task.world->symbols().Find("throwIt"), {0}};
  const GroundAct carried{*task.world->symbols().Find("carry"), {0}};
  RexD learner(task, {});
  for (int i = 0; i < 3; ++i) {
    learner.Observe({state("here(cup)"), carried, state("half(cup)")});
    learner.Observe({state("half(cup)"), carried, state("there(cup)")});
    learner.Observe({state("here(cup)"), thrown, state("there(cup)")});
  }
  // Of two ways that reach the goal it prefers the shorter one,
  const auto quick = learner.Plan(task.initial);
  ASSERT_TRUE(quick.has_value());
  EXPECT_EQ(*quick, thrown);
  // until that has led to a state without a way on.
  learner.Observe({state("here(cup)"), thrown, state("broken(cup)")});
  learner.RememberDeadEnd();
  const auto safe = learner.Plan(task.initial);
  ASSERT_TRUE(safe.has_value());
  EXPECT_EQ(*safe, carried);
}

TEST(PlanningTeacher, ShowsWhatTheLearnerDoesNotPredict) {
  const RexdTask task = PlacingTask();
  PlanningTeacher teacher(task, 1, {}, 1);
  NdrRules known = task.truth;
  const GroundAct red{*task.world->symbols().Find("place"), {0}};
  EXPECT_EQ(teacher.UsefulActs(task.initial).size(), 2u);
  // The learner believes that only blue can be placed.
  known.rules[0].context.push_back(
      {Literal::kSame,
       {{Term::Kind::kVariable, 0}, {Term::Kind::kObject, 1}},
       Comparison::kTrue,
       0});
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(teacher.Choose(task.initial, {&known}), red);
  }
}

TEST(PlanningTeacher, HasNothingToShowInADeadEnd) {
  const RexdTask task = PlacingTask();
  PlanningTeacher teacher(task, 1, {}, 1);
  WorldState state = task.initial;
  const int closed = *task.world->symbols().Find("closed");
  World::Set(&state, task.world->first(closed), true);
  EXPECT_EQ(teacher.Choose(state, {}), std::nullopt);
}

}  // namespace
}  // namespace cell::rexd
