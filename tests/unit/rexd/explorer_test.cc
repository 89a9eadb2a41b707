#include "common/rexd/explorer.h"

#include <gtest/gtest.h>

#include "common/rexd/ppddl_import.h"
#include "common/rexd/test_run.h"
#include "common/rules/rule_text.h"

namespace cell::rexd {
namespace {

using namespace rules;

// A lift carries a load up and down; a load fits only an empty one.
constexpr char kLiftDomain[] = R"((define (domain lifts)
  (:requirements :typing :negative-preconditions :probabilistic-effects)
  (:types load - object)
  (:predicates (in ?l - load) (at-top ?l - load) (up) (full))
  (:action put-in :parameters (?l - load)
    :precondition (and (not (up)) (not (full)) (not (at-top ?l)))
    :effect (and (in ?l) (full)))
  (:action go-up :parameters () :precondition (not (up)) :effect (up))
  (:action go-down :parameters () :precondition (up)
    :effect (probabilistic 0.75 (not (up))))
  (:action take-out :parameters (?l - load) :precondition (and (in ?l) (up))
    :effect (and (not (in ?l)) (not (full)) (at-top ?l)))))";
constexpr char kLiftProblem[] = R"((define (problem two) (:domain lifts)
  (:objects crate sack - load) (:init )
  (:goal (and (at-top crate) (at-top sack) (not (up))))))";

RexdTask TaskOf(const std::string& domain) {
  return ParseRexdTask(TaskOfPpddl({domain, "d"}, {kLiftProblem, "p"}), "p");
}

std::string Replaced(std::string text, const std::string& from,
                     const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// After so many actions of an explorer, which begins again after each 20: a
/// load at the top stays there.
NdrRules Explore(const RexdTask& task, int num_actions, uint64_t seed) {
  Explorer::Params params;
  params.seed = seed;
  Explorer explorer(task, params);
  RandomNumbers random(seed);
  WorldState state = task.initial;
  for (int i = 0; i < num_actions; ++i) {
    if (i % 20 == 0) state = task.initial;
    const GroundAct act = explorer.Choose(state);
    const WorldState after =
        Simulate(task.truth, *task.world, act, state, &random);
    explorer.Observe({state, act, after});
    state = after;
  }
  return explorer.rules();
}

TEST(Explorer, LearnsEnoughToReachTheGoalWithoutATeacher) {
  // Each situation is tried once: nothing may fail by chance.
  const auto task = TaskOf(
      Replaced(kLiftDomain, "(probabilistic 0.75 (not (up)))", "(not (up))"));
  int num_reached = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const TestRun before = RunTest(Explore(task, 2, seed), task);
    EXPECT_FALSE(before.is_goal_reached) << seed;
    num_reached += RunTest(Explore(task, 60, seed), task).is_goal_reached;
  }
  EXPECT_EQ(num_reached, 5);
}

TEST(Explorer, EqualSeedsGiveEqualRules) {
  const auto task = TaskOf(kLiftDomain);
  EXPECT_EQ(ToText(Explore(task, 30, 3)), ToText(Explore(task, 30, 3)));
}

TEST(Explorer, AWorldWithoutPossibleActionsIsAnError) {
  const auto task = ParseRexdTask(
      "objects: a\nstart:\ngoal: p(a)\np 1 primitive\n"
      "act 1 action <-- p(X)\n",
      "t");
  EXPECT_THROW(Explorer(task, {}), std::invalid_argument);
}

TEST(RunTest, TriesAgainWhatMayFailAndEndsAtTheGoal) {
  const auto task = TaskOf(kLiftDomain);
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    TestRunParams params;
    params.seed = seed;
    const TestRun run = RunTest(task.truth, task, params);
    EXPECT_TRUE(run.is_goal_reached);
    EXPECT_GE(run.num_actions, 8);
  }
}

TEST(RunTest, FailsByRulesThatKnowNoWay) {
  const auto task = TaskOf(kLiftDomain);
  NdrRules rules = task.truth;
  rules.rules.pop_back();
  EXPECT_FALSE(RunTest(rules, task).is_goal_reached);
}

}  // namespace
}  // namespace cell::rexd
