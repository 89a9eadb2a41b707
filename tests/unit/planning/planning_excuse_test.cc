#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "common/planning/all_changes.h"
#include "common/planning/excuse.h"
#include "common/planning/planner.h"
#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::vector<std::string> ChangesOf(const Excuse& excuse,
                                   const GroundTask& task) {
  std::vector<std::string> names;
  for (const RequiredChange& change : excuse.changes) {
    names.push_back(Show(change.literal, task.atoms));
  }
  return names;
}

TEST(Excuse, NothingIsNeededWhereThereIsAPlan) {
  const Excuses excuses =
      FindExcuses(TaskOf(kCourier, kDelivery, ConstantAtoms::kKeep));
  EXPECT_TRUE(excuses.is_solvable);
  EXPECT_THAT(excuses.excuses, IsEmpty());
}

TEST(Excuse, ABrokenBridgeIsNamedInPlainWords) {
  const GroundTask task =
      TaskOf(kCourier, With(kDelivery, "(at depot)", "(at depot) (broken)"),
             ConstantAtoms::kKeep);
  ExcuseOptions options;
  options.may_change = [&](const Literal& l) {
    const std::string& name = task.atoms[static_cast<size_t>(l.atom)].predicate;
    return name != "road" && name != "bridge" && name != "at";
  };
  const Excuses excuses = FindExcuses(task, options);
  EXPECT_TRUE(excuses.is_minimal);
  ASSERT_THAT(excuses.excuses, Not(IsEmpty()));
  const Excuse& best = excuses.excuses.front();
  EXPECT_THAT(ChangesOf(best, task), testing::ElementsAre("not broken()"));
  EXPECT_FALSE(best.changes[0].has_producer);
  EXPECT_THAT(Explain(best, task),
              AllOf(HasSubstr("cross("), HasSubstr("needs: not broken(); but "),
                    HasSubstr("no action changes that")));
  EXPECT_THAT(
      Explain(best, task,
              {{"broken", {"the bridge is broken", "the bridge holds"}}}),
      HasSubstr("needs: the bridge holds; but the bridge is broken"));
}

TEST(Excuse, SubgoalsAreWhatCanBeDoneMeanwhile) {
  const GroundTask task =
      TaskOf(kCourier, With(kDelivery, "(at depot)", "(at depot) (broken)"),
             ConstantAtoms::kKeep);
  ExcuseOptions options;
  options.may_change = [&](const Literal& l) {
    return task.atoms[static_cast<size_t>(l.atom)].predicate == "broken";
  };
  const Excuses excuses = FindExcuses(task, options);
  ASSERT_THAT(excuses.excuses, SizeIs(1));
  std::vector<std::string> subgoals;
  for (const Literal& l : excuses.excuses[0].subgoals) {
    subgoals.push_back(Show(l, task.atoms));
  }
  EXPECT_THAT(subgoals, Contains("loaded(x)"));
  EXPECT_THAT(subgoals, Contains("at(m)"));
  EXPECT_THAT(subgoals, Not(Contains("not broken()")));
}

TEST(Excuse, AssumingTheGoalComesLastAmongEqualOnes) {
  // Nothing produces p0 at all.
  const GroundTask task = TaskOf(
      "(define (domain d) (:predicates (p) (q)) (:action f :effect (q)))",
      "(define (problem p) (:domain d) (:goal (p)))", ConstantAtoms::kKeep);
  const Excuses excuses = FindExcuses(task);
  ASSERT_THAT(excuses.excuses, SizeIs(1));
  EXPECT_THAT(ChangesOf(excuses.excuses[0], task), testing::ElementsAre("p()"));
}

/// Random STRIPS tasks with negative preconditions.
GroundTask RandomStripsTask(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto literal = [&] {
    return Literal{static_cast<int>(random() % 7), random() % 3 != 0};
  };
  GroundTask task;
  for (int i = 0; i < 7; ++i) {
    task.atoms.push_back({"p" + std::to_string(i), {}});
    task.initial.push_back(random() % 3 == 0);
  }
  for (int a = 0; a < 4; ++a) {
    task.actions.push_back({"a" + std::to_string(a),
                            {{literal(), literal()}, {}},
                            {{1, {{{}, {literal(), literal()}}}}}});
  }
  Conjunction goal;
  for (int i = 0; i < 4; ++i) {
    goal.literals.push_back({i, random() % 3 != 0});
  }
  task.goals = {goal};
  return task;
}

bool IsSolvable(GroundTask task, const std::vector<int>& flipped) {
  for (const int atom : flipped) {
    task.initial[static_cast<size_t>(atom)].flip();
  }
  return PlanOf(task).status != Plan::Status::kNoPlan;
}

/// The fewest flips of atoms that help, by trying all up to four.
size_t FewestFlips(const GroundTask& task) {
  const auto helps = [&](const Changes& changes) {
    std::vector<int> atoms;
    for (const Literal& l : changes) atoms.push_back(l.atom);
    return IsSolvable(task, atoms);
  };
  for (int size = 1; size <= 4; ++size) {
    if (FindAmongAllChanges(task, size, helps)) {
      return static_cast<size_t>(size);
    }
  }
  return 0;
}

TEST(AllChanges, AreTriedInOrderUntilOneHelps) {
  const GroundTask task = RandomStripsTask(1);
  std::set<Changes> tried;
  const auto helps = [&](const Changes& changes) {
    for (const Literal& l : changes) {
      EXPECT_NE(task.initial[static_cast<size_t>(l.atom)], l.value);
    }
    EXPECT_TRUE(tried.insert(changes).second);
    return changes.back().atom == 6;
  };
  int64_t num_tried = 0;
  const auto found = FindAmongAllChanges(task, 3, helps, &num_tried);
  ASSERT_TRUE(found);
  EXPECT_EQ(num_tried, 5);  // 012, 013, 014, 015, 016
  EXPECT_EQ(found->front().atom, 0);
  EXPECT_FALSE(FindAmongAllChanges(
      task, 2, [](const Changes&) { return false; }, &num_tried));
  EXPECT_EQ(num_tried, 5 + 21);
}

TEST(Excuse, WhatIsGivenIsDoubtedAfterWhatActionsBringAbout) {
  // The gate is shut for want of a ticket; another gate would be open.
  const GroundTask task = TaskOf(R"((define (domain d)
  (:predicates (at ?p) (way ?a ?b) (ticket))
  (:action go :parameters (?a ?b)
    :precondition (and (at ?a) (way ?a ?b) (ticket))
    :effect (and (at ?b) (not (at ?a))))
  (:action jump :parameters (?a ?b)
    :precondition (and (at ?a) (way ?b ?a))
    :effect (and (at ?b) (not (at ?a))))))",
                                 R"((define (problem p) (:domain d)
  (:objects a b) (:init (at a) (way a b)) (:goal (and (at b)))))",
                                 ConstantAtoms::kKeep);
  const Excuses excuses = FindExcuses(task);
  ASSERT_GE(excuses.excuses.size(), 2u);
  EXPECT_THAT(ChangesOf(excuses.excuses[0], task),
              testing::ElementsAre("ticket()"));
  EXPECT_THAT(ChangesOf(excuses.excuses[1], task),
              testing::ElementsAre("way(b, a)"));
}

TEST(Excuse, NoSmallerChangeWouldDoAndEachOneHelps) {
  int num_hard = 0;
  int num_large = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    const GroundTask task = RandomStripsTask(seed);
    ExcuseOptions options;
    options.max_changes = 4;
    const Excuses excuses = FindExcuses(task, options);
    ASSERT_EQ(excuses.is_solvable, IsSolvable(task, {})) << seed;
    if (excuses.is_solvable) continue;
    ++num_hard;
    const size_t fewest = FewestFlips(task);
    EXPECT_TRUE(excuses.is_minimal) << seed;
    EXPECT_EQ(excuses.excuses.empty(), fewest == 0) << seed;
    for (const Excuse& excuse : excuses.excuses) {
      EXPECT_EQ(excuse.changes.size(), fewest) << seed;
      std::vector<int> atoms;
      for (const auto& change : excuse.changes) {
        atoms.push_back(change.literal.atom);
      }
      EXPECT_TRUE(IsSolvable(task, atoms)) << seed;
    }
    num_large += fewest > 1;
  }
  EXPECT_GT(num_hard, 50);
  EXPECT_GT(num_large, 50);
}

}  // namespace
}  // namespace cell::planning
