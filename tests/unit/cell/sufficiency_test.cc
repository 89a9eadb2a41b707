#include "services/cell/learning/sufficiency.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/unit/bench_domain.h"

namespace cell::cli {
namespace {

/// The bench's rules without those of the actions that nobody has shown.
std::shared_ptr<const RuleSet> BenchWithout(
    const BenchDomain& bench, const std::set<std::string>& not_shown) {
  std::vector<Action> actions = bench.rules->actions();
  for (Action& action : actions) {
    if (not_shown.contains(action.name)) action.rules.clear();
  }
  return std::make_shared<const RuleSet>(
      "shown", 1, bench.rules->shared_vocabulary(), actions);
}

std::vector<std::string> Names(const std::vector<Literal>& literals,
                               const BenchDomain& bench) {
  std::vector<std::string> names;
  for (const Literal& literal : literals) {
    names.push_back(Show(literal, {}, bench.rules->vocabulary()));
  }
  return names;
}

TEST(Sufficiency, IsThereIfAPlanReachesTheGoal) {
  const BenchDomain bench;
  const std::vector<State> starts = {bench.StateOf({}),
                                     bench.StateOf({"In(bolt_1, hole_2)"})};
  const auto judged =
      JudgeSufficiency(bench.rules, bench.GoalOf("done"), starts);
  EXPECT_TRUE(judged.is_sufficient);
  EXPECT_TRUE(judged.uncovered.empty());
  EXPECT_THROW(JudgeSufficiency(bench.rules, bench.GoalOf("done"), {}),
               std::invalid_argument);
}

TEST(Sufficiency, NamesThePartsOfTheGoalThatAreNotCovered) {
  const BenchDomain bench(BenchWith("done: [Closed(lid)]",
                                    "done: [\"In(_, hole_1)\", Closed(lid)]"));
  const std::vector<State> starts = {bench.StateOf({})};
  const Goal& goal = bench.GoalOf("done");
  const auto no_lid =
      JudgeSufficiency(BenchWithout(bench, {"Close"}), goal, starts);
  EXPECT_FALSE(no_lid.is_sufficient);
  EXPECT_EQ(no_lid.num_without_plan, 1);
  EXPECT_EQ(Names(no_lid.uncovered, bench),
            std::vector<std::string>{"Closed(lid)"});
  const auto nothing =
      JudgeSufficiency(BenchWithout(bench, {"Close", "Insert"}), goal, starts);
  EXPECT_EQ(nothing.uncovered.size(), 2U);
}

TEST(Sufficiency, TellsIfOnlyAllPartsTogetherAreOutOfReach) {
  const BenchDomain bench(BenchWith(
      "done: [Closed(lid)]", "done: [\"not In(_, hole_1)\", Closed(lid)]"));
  const std::vector<State> starts = {bench.StateOf({})};
  const auto judged =
      JudgeSufficiency(bench.rules, bench.GoalOf("done"), starts);
  EXPECT_FALSE(judged.is_sufficient);
  EXPECT_TRUE(judged.uncovered.empty());
}

/// Its holes are sites, which rules may name.
std::string BenchWithSites() {
  std::string text = kBench;
  for (size_t at = 0; (at = text.find("hole_", at)) != std::string::npos;
       at += 7) {
    text.insert(at, "b.");
  }
  return text;
}

/// Learned from the bench's own assemblies, in both orders of the bolts.
TEST(Sufficiency, ComesWithTheLastStepThatIsShown) {
  const BenchDomain bench(BenchWithSites());
  const RuleWorld world(bench.rules->shared_vocabulary(),
                        bench.domain.actions());
  const State start = bench.StateOf({});
  std::vector<rules::Experience> shown;
  const auto show = [&](const std::string& name,
                        const std::vector<std::string>& objects,
                        const State& before, const State& after) {
    shown.push_back(
        world.ToExperience(before, bench.Action(name, objects), after));
  };
  for (const std::string hole : {"b.hole_1", "b.hole_2"}) {
    const std::string other = hole == "b.hole_1" ? "b.hole_2" : "b.hole_1";
    const std::string first = "In(bolt_1, " + hole + ")";
    const State one = bench.StateOf({first});
    const State both = bench.StateOf({first, "In(bolt_2, " + other + ")"});
    show("Insert", {"bolt_1", hole}, start, one);
    show("Insert", {"bolt_2", other}, one, both);
  }
  const Goal& goal = bench.GoalOf("done");
  const std::vector<State> starts = {start};
  auto learned = LearnedRuleSet(shown, bench.domain.goals(), world);
  EXPECT_FALSE(JudgeSufficiency(learned, goal, starts).is_sufficient);
  EXPECT_FALSE(ReachesGoal(learned, goal, *bench.rules, start));
  for (const auto& [a, b] : {std::pair{"1", "2"}, std::pair{"2", "1"}}) {
    const std::string first = std::string("In(bolt_") + a + ", b.hole_1)";
    const std::string second = std::string("In(bolt_") + b + ", b.hole_2)";
    show("Close", {"lid"}, bench.StateOf({first, second}),
         bench.StateOf({first, second, "Closed(lid)"}));
  }
  learned = LearnedRuleSet(shown, bench.domain.goals(), world);
  EXPECT_TRUE(JudgeSufficiency(learned, goal, starts).is_sufficient);
  EXPECT_TRUE(ReachesGoal(learned, goal, *bench.rules, start));
}

/// A frozen plan whose first step does nothing does nothing again.
TEST(Sufficiency, AWrongRuleReachesNothing) {
  const BenchDomain bench;
  const BenchDomain wrong(BenchWith(
      "\"In(_, hole_1)\", \"In(_, hole_2)\", not Closed(X)", "not Closed(X)"));
  const Goal& goal = bench.GoalOf("done");
  const State start = bench.StateOf({});
  EXPECT_TRUE(
      JudgeSufficiency(wrong.rules, goal, std::vector{start}).is_sufficient);
  EXPECT_FALSE(ReachesGoal(wrong.rules, goal, *bench.rules, start));
}

}  // namespace
}  // namespace cell::cli
