#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

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

TEST(Excuse, AssumingTheGoalComesLast) {
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
  task.goals = {{{literal(), literal()}, {}}};
  return task;
}

bool IsSolvable(GroundTask task, const std::vector<int>& flipped) {
  for (const int atom : flipped) {
    task.initial[static_cast<size_t>(atom)].flip();
  }
  return PlanOf(task).status != Plan::Status::kNoPlan;
}

/// The fewest flips of atoms that the goal does not speak of, or of all atoms
/// if those do not help; by trying all up to three.
size_t FewestFlips(const GroundTask& task, bool may_wish) {
  const auto may_flip = [&](int atom) {
    const bool value = !task.initial[static_cast<size_t>(atom)];
    return may_wish || std::ranges::count(task.goals[0].literals,
                                          Literal{atom, value}) == 0;
  };
  for (size_t size = 1; size <= 3; ++size) {
    for (int set = 1; set < 128; ++set) {
      std::vector<int> atoms;
      for (int atom = 0; atom < 7; ++atom) {
        if ((set >> atom & 1) != 0) atoms.push_back(atom);
      }
      if (atoms.size() == size && std::ranges::all_of(atoms, may_flip) &&
          IsSolvable(task, atoms)) {
        return size;
      }
    }
  }
  return may_wish ? 0 : FewestFlips(task, true);
}

TEST(Excuse, NoSmallerChangeWouldDoAndEachOneHelps) {
  int num_hard = 0;
  int num_large = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    const GroundTask task = RandomStripsTask(seed);
    const Excuses excuses = FindExcuses(task);
    ASSERT_EQ(excuses.is_solvable, IsSolvable(task, {})) << seed;
    if (excuses.is_solvable) continue;
    ++num_hard;
    const size_t fewest = FewestFlips(task, false);
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
  EXPECT_GT(num_large, 10);
}

}  // namespace
}  // namespace cell::planning
