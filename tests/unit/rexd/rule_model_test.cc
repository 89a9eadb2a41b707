#include "common/rexd/rule_model.h"

#include <gmock/gmock.h>

#include "common/planning/planner.h"
#include "common/rules/rule_error.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;
using testing::HasSubstr;

std::shared_ptr<RuleModel> ModelOf(const RexdTask& task, double success) {
  return std::make_shared<RuleModel>(WithSuccess(task.truth, success), task,
                                     GroundActs(*task.world, task.initial));
}

std::string TaskErrorOf(const std::string& text) {
  try {
    ParseRexdTask(text, "t");
  } catch (const RuleError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RuleModel, PlansTheActionsThatTheRulesNeed) {
  const RexdTask task = PlacingTask();
  const auto model = ModelOf(task, 1);
  planning::Planner planner(model, {});
  const planning::Plan plan = planner.Find(model->Pack(task.initial));
  ASSERT_EQ(plan.status, planning::Plan::Status::kFound);
  ASSERT_EQ(plan.course.size(), 3u);
  EXPECT_EQ(plan.course[2].name, "close(lid)");
}

TEST(RuleModel, ActionsThatFailAreRepeated) {
  const RexdTask task = PlacingTask();
  const auto model = ModelOf(task, 0.5);
  planning::Planner planner(model, {});
  const planning::Plan plan = planner.Find(model->Pack(task.initial));
  ASSERT_EQ(plan.status, planning::Plan::Status::kFound);
  EXPECT_GT(plan.probability.low, 0.999);
  EXPECT_NEAR(plan.expected_actions, 6, 1e-2);
}

TEST(RuleModel, KnowsThatAGoalWhichNoRuleBringsAboutIsOutOfReach) {
  const RexdTask task = PlacingTask();
  NdrRules rules = task.truth;
  rules.rules.pop_back();
  const RuleModel model(rules, task, GroundActs(*task.world, task.initial));
  std::vector<uint64_t> state = model.Pack(task.initial);
  EXPECT_EQ(model.Assess(state).max_probability, 0);
}

TEST(RuleModel, ClearsAtomsThatNothingAsksFor) {
  const RexdTask task = ParseRexdTask(
      "objects: a\nstart: thing(a)\ngoal: done()\n"
      "thing 1 primitive\ndone 0 primitive\ndirty 1 primitive\n"
      "work 1 action\nAction: work(X)\nPreconditions: thing(X)\nEffects:\n"
      "  1: done(), dirty(X)\n  0: noise\n",
      "t");
  const RuleModel model(task.truth, task,
                        GroundActs(*task.world, task.initial));
  std::vector<uint64_t> clean = model.Pack(task.initial);
  WorldState state = task.initial;
  const int dirty = *task.world->symbols().Find("dirty");
  World::Set(&state, task.world->PlaceOf(dirty, std::vector<int>{0}), true);
  std::vector<uint64_t> words = model.Pack(state);
  EXPECT_NE(words, clean);
  model.Assess(words);
  model.Assess(clean);
  EXPECT_EQ(words, clean);
}

TEST(RexdTask, WithSuccessLeavesTheRestToNothing) {
  const RexdTask task = PlacingTask();
  const NdrRules rules = WithSuccess(task.truth, 0.4);
  EXPECT_DOUBLE_EQ(rules.rules[0].outcomes[0].probability, 0.4);
  EXPECT_DOUBLE_EQ(rules.rules[0].noise, 0.6);
}

TEST(RexdTask, ErrorsNameFileAndLine) {
  EXPECT_THAT(TaskErrorOf("start: \ngoal: x()\n"),
              HasSubstr("t:1: a line 'objects: ...' is missing"));
  const std::string head = "objects: a\nstart: p(a)\n";
  EXPECT_THAT(TaskErrorOf(head + "goal: q(a)\np 1 primitive\n"),
              HasSubstr("t:3: there is no predicate 'q'"));
  EXPECT_THAT(TaskErrorOf(head + "goal: p(b)\np 1 primitive\n"),
              HasSubstr("t:3: there is no object 'b'"));
  EXPECT_THAT(TaskErrorOf(head + "goal: p(a)\np 1 primitve\n"),
              HasSubstr("t:4: "));
}

}  // namespace
}  // namespace cell::rexd
