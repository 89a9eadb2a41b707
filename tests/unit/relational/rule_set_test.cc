#include "common/relational/rule_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/bench_domain.h"

namespace cell {
namespace {

using testing::HasSubstr;

std::string Refusal(const std::string& text, int64_t version = 2) {
  const BenchDomain current;
  const BenchDomain next(text, version);
  return next.rules->WhyNotReplace(*current.rules).value_or("");
}

TEST(RuleSet, SaysWhatTheDomainSays) {
  const BenchDomain bench;
  const RuleSet& rules = *bench.rules;
  EXPECT_EQ(rules.version(), 1);
  EXPECT_EQ(rules.GroundActions(Agent::kRobot),
            bench.domain.GroundActions(Agent::kRobot));
  const GroundAction insert = bench.Action("Insert", {"bolt_2", "hole_1"});
  EXPECT_EQ(rules.Show(insert), "Insert(bolt_2, hole_1)");
  EXPECT_EQ(rules.SkillOf(insert), bench.domain.SkillOf(insert));
  EXPECT_EQ(rules.ActionOf(insert).name, "Insert");
  EXPECT_FALSE(rules.FindGroundAction("Insert", {"hole_1", "bolt_2"}));
}

TEST(RuleSet, ReplacesOneOfTheSameWordsWithOtherRules) {
  EXPECT_EQ(Refusal(kBench), "");
  EXPECT_EQ(Refusal(BenchWith("\"not In(X, _)\", ", "")), "");
}

TEST(RuleSet, MayAddActionsAfterThoseInUse) {
  EXPECT_EQ(Refusal(BenchWith("goals:",
                              "  Open:\n    arguments: {X: lid}\n    rules:\n"
                              "      - {context: [Closed(X)], noise: 0,\n"
                              "         outcomes: [{probability: 1, effects: "
                              "[not Closed(X)]}]}\ngoals:")),
            "");
}

TEST(RuleSet, OfNoHigherVersionIsRefused) {
  EXPECT_EQ(Refusal(kBench, 1),
            "bench:version: is 1; must be more than 1, which is used");
}

TEST(RuleSet, OfAnotherDomainIsRefusedWithWhatWouldBeRight) {
  EXPECT_EQ(
      Refusal(BenchWith("bolt_2: bolt, lid: lid", "bolt_3: bolt, lid: lid")),
      "bench:objects[1]: is 'bolt_3: bolt'; must be 'bolt_2: bolt', as "
      "in the task's domain");
  EXPECT_EQ(Refusal(BenchWith("hole: object, arm", "hole: part, arm")),
            "bench:types[4]: is 'hole (object, part, hole)'; must be 'hole "
            "(object, hole)', as in the task's domain");
  EXPECT_EQ(
      Refusal(BenchWith("Held: {arguments: [part, arm], reported: held}",
                        "Held: {arguments: [part, arm]}")),
      "bench:predicates[1]: is 'Held(part, arm)'; must be 'Held(part, arm), "
      "reported: held', as in the task's domain");
  EXPECT_THAT(
      Refusal(BenchWith("predicates:",
                        "static_facts: {fits: {arguments: [bolt, hole], facts: "
                        "[[bolt_1, hole_1]]}}\npredicates:")),
      HasSubstr("static_facts"));
}

TEST(RuleSet, ThatLacksOrMovesAnActionInUseIsRefused) {
  const BenchDomain bench;
  std::vector<Action> actions = bench.domain.actions();
  std::swap(actions[0], actions[1]);
  const RuleSet moved("record 7", 2, bench.rules->shared_vocabulary(), actions);
  EXPECT_THAT(moved.WhyNotReplace(*bench.rules).value_or(""),
              HasSubstr("record 7:actions[0]: is Close(lid); must be "
                        "Insert(bolt, hole)"));
  actions = bench.domain.actions();
  actions.pop_back();
  const RuleSet fewer("record 7", 2, bench.rules->shared_vocabulary(), actions);
  EXPECT_THAT(fewer.WhyNotReplace(*bench.rules).value_or(""),
              HasSubstr("actions[3]: is nothing; must be PutDown(part, arm)"));
}

}  // namespace
}  // namespace cell
