#include "common/rexd/dead_end_memory.h"

#include <gmock/gmock.h>

#include "common/rexd/dangerous_acts.h"
#include "common/rexd/rexd_run.h"
#include "common/rules/data_text.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;

// Two cups, each of which may break or be lost when it is thrown across.
constexpr char kCupsTask[] = R"(
objects: red blue lid
start: here(red) here(blue) cup(red) cup(blue)
goal: there(red) there(blue)
cup 1 primitive
here 1 primitive
half 1 primitive
there 1 primitive
broken 1 primitive
lost 1 primitive
throwIt 1 action <-- cup(X)
carry 1 action <-- cup(X)

Action: throwIt(X)
Preconditions: here(X)
Effects:
  0.6: not here(X), there(X)
  0.2: not here(X), broken(X)
  0.2: not here(X), lost(X)
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

class DeadEndsOfCups : public testing::Test {
 protected:
  WorldState State(const std::string& text) const {
    return ParseState("cup(red) cup(blue) " + text, "s", 1, *task_.world);
  }
  GroundAct Act(const char* action, const char* object) const {
    return {*task_.world->symbols().Find(action),
            {*task_.world->FindObject(object)}};
  }

  RexdTask task_ = ParseRexdTask(kCupsTask, "t");
  DeadEndMemory memory_{task_};
};

TEST_F(DeadEndsOfCups, WhatNoLivingStateHasIsTheReason) {
  memory_.AddAlive(State("here(red) here(blue)"));
  memory_.AddAlive(State("here(red) there(blue)"));
  EXPECT_FALSE(memory_.LooksDead(State("broken(blue) here(red)")));
  memory_.AddDeadEnd(State("there(blue) broken(red)"));
  EXPECT_EQ(memory_.ToText(), "broken(A)\n");
  EXPECT_TRUE(memory_.LooksDead(State("broken(blue) here(red)")));
  EXPECT_FALSE(memory_.LooksDead(State("there(red) here(blue)")));
}

TEST_F(DeadEndsOfCups, WhatTheGoalAsksForIsNoReason) {
  memory_.AddAlive(State("here(red) here(blue)"));
  // No state with there(...) has been seen to be alive.
  memory_.AddDeadEnd(State("there(blue) broken(red)"));
  EXPECT_EQ(memory_.ToText(), "broken(A)\nno longer here(A)\n");
}

TEST_F(DeadEndsOfCups, ASuspicionIsGivenUpWhenTheGoalIsReachedAllTheSame) {
  memory_.AddAlive(State("here(red) here(blue)"));
  memory_.AddDeadEnd(State("half(blue) broken(red)"));
  EXPECT_TRUE(memory_.LooksDead(State("half(blue) here(red)")));
  memory_.AddAlive(State("half(blue) here(red)"));
  EXPECT_FALSE(memory_.LooksDead(State("half(blue) here(red)")));
  EXPECT_EQ(memory_.ToText(), "broken(A)\n");
}

TEST_F(DeadEndsOfCups, AnActIsDangerousIfItHasEverDoneSuchAThing) {
  DangerousActs dangers(task_);
  const WorldState start = State("here(red) here(blue)");
  const WorldState thrown = State("there(red) here(blue)");
  const WorldState broken = State("there(red) broken(blue)");
  dangers.Observe({start, Act("throwIt", "red"), thrown}, true);
  dangers.Observe({thrown, Act("throwIt", "blue"), broken}, false);
  // The experience that is the last is not the one to blame.
  dangers.Observe({broken, Act("carry", "blue"), broken}, false);
  EXPECT_FALSE(dangers.IsDangerous(Act("throwIt", "red"), start));
  dangers.RememberDeadEnd();
  EXPECT_TRUE(dangers.IsDangerous(Act("throwIt", "red"), start));
  EXPECT_TRUE(dangers.IsDangerous(Act("throwIt", "blue"), start));
  EXPECT_FALSE(dangers.IsDangerous(Act("carry", "red"), start));
}

TEST(DeadEndMemory, TwoFactsAreAReasonWhereNoneOfThemIsOne) {
  const RexdTask task = PlacingTask();
  const auto state = [&](const std::string& text) {
    return ParseState("book(red) book(blue) cover(lid) " + text, "s", 1,
                      *task.world);
  };
  DeadEndMemory memory(task);
  memory.AddAlive(state(""));
  memory.AddAlive(state("placed(red)"));
  memory.AddAlive(state("placed(red) placed(blue)"));
  memory.AddAlive(state("placed(red) placed(blue) closed()"));
  // The shelf was closed too early.
  memory.AddDeadEnd(state("placed(red) closed()"));
  EXPECT_EQ(memory.ToText(), "closed() and missing placed(A)\n");
  EXPECT_TRUE(memory.LooksDead(state("placed(blue) closed()")));
  EXPECT_TRUE(memory.LooksDead(state("closed()")));
  EXPECT_FALSE(memory.LooksDead(state("placed(blue)")));
}

TEST(RunRexd, ADeadEndIsNotMetAgainByTheSameKindOfAction) {
  const RexdTask task = ParseRexdTask(kCupsTask, "t");
  int num_fallen = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    RunParams params;
    params.seed = seed;
    params.num_episodes = 6;
    int num_falls = 0;
    for (const EpisodeCounts& counts : RunRexd(task, params)) {
      EXPECT_TRUE(num_falls == 0 || counts.is_goal_reached) << seed;
      num_falls += counts.fatal_rule.has_value();
      EXPECT_EQ(counts.fatal_rule.value_or(0), 0);
    }
    EXPECT_LE(num_falls, 1) << seed;
    num_fallen += num_falls;
  }
  EXPECT_GT(num_fallen, 20);
}

}  // namespace
}  // namespace cell::rexd
