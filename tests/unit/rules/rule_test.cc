#include "common/rules/rule.h"

#include <gmock/gmock.h>

#include "common/rules/simulation.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

using testing::ElementsAre;

constexpr char kRulesOfCups[] = R"(
shelf 0 constant
cup 1 primitive
on 2 primitive
held 1 primitive
weight 1 primitive integers
lift 1 action <-- cup(X)

Action: lift(X)
References: Y: on(X, Y)
Preconditions: not held(_), weight(X) <= 4, Y != shelf
Effects:
  0.75: held(X), not on(X, Y)
  0.25: noise

Action: lift(X)
Preconditions: on(X, shelf)
Effects:
  1: held(X)
  0: noise
)";

class RuleOfCups : public testing::Test {
 protected:
  WorldState StateOf(const std::string& text) const {
    return ParseState(text, "d", 1, world_);
  }
  GroundAct Lift(const std::string& object) const {
    return {*world_.symbols().Find("lift"), {*world_.FindObject(object)}};
  }
  bool IsCovered(const std::string& state, const std::string& object) const {
    return FindCoverage(rules_, Lift(object), StateOf(state), world_)
        .has_value();
  }

  NdrRules rules_ = ParseRules(kRulesOfCups, "r");
  World world_{rules_.symbols, ObjectsFrom("abc")};
};

TEST_F(RuleOfCups, CoversAStateInWhichItsConditionsHold) {
  EXPECT_TRUE(IsCovered("cup(a) on(a b) weight(a)=4", "a"));
  EXPECT_FALSE(IsCovered("cup(a) on(a b) weight(a)=5", "a"));
  EXPECT_FALSE(IsCovered("cup(a) on(a b) weight(a)=4 held(c)", "a"));
  // A function without a value satisfies no comparison.
  EXPECT_FALSE(IsCovered("cup(a) on(a b)", "a"));
}

TEST_F(RuleOfCups, DoesNotCoverWhenAReferenceIsNotUnique) {
  EXPECT_FALSE(IsCovered("cup(a) weight(a)=4", "a"));
  EXPECT_FALSE(IsCovered("cup(a) on(a b) on(a c) weight(a)=4", "a"));
}

TEST_F(RuleOfCups, TwoRulesThatCoverAnActionAreTheDefaultRule) {
  NdrRules rules = rules_;
  rules.rules[1].context.clear();
  const WorldState state = StateOf("cup(a) on(a b) weight(a)=1");
  EXPECT_TRUE(FindCoverage(rules_, Lift("a"), state, world_).has_value());
  EXPECT_FALSE(FindCoverage(rules, Lift("a"), state, world_).has_value());
}

TEST_F(RuleOfCups, AnOutcomeChangesWhatItSaysAndNoMore) {
  const WorldState before = StateOf("cup(a) on(a b) on(c b) weight(a)=1");
  const auto coverage = FindCoverage(rules_, Lift("a"), before, world_);
  ASSERT_TRUE(coverage.has_value());
  const WorldState after =
      Apply(coverage->rule->outcomes[0], coverage->binding, before, world_);
  EXPECT_EQ(ToText(after, world_), "cup(a) on(c, b) held(a) weight(a)=1");
}

TEST_F(RuleOfCups, ActionsHaveTheArgumentsThatTheirConditionAllows) {
  const auto acts =
      GroundActs(world_, StateOf("cup(a) cup(c) on(a b) on(c b)"));
  EXPECT_THAT(acts, ElementsAre(Lift("a"), Lift("c")));
}

TEST_F(RuleOfCups, SimulatedOutcomesHaveTheirProbabilities) {
  const WorldState before = StateOf("cup(a) on(a b) weight(a)=1");
  RandomNumbers random(3);
  int num_lifted = 0;
  for (int i = 0; i < 1000; ++i) {
    num_lifted +=
        Simulate(rules_, world_, Lift("a"), before, &random) != before;
  }
  EXPECT_NEAR(num_lifted, 750, 60);  // more than four standard deviations
}

TEST(Opposite, OfAComparisonHoldsWhereItDoesNot) {
  const auto symbols = SymbolsFrom("f 0 primitive integers\n");
  const World world(symbols, {});
  WorldState state = world.EmptyState();
  for (int value = -2; value <= 2; ++value) {
    state.values[0] = value;
    for (const auto comparison : {Comparison::kEqual, Comparison::kNotEqual,
                                  Comparison::kAtMost, Comparison::kAtLeast}) {
      Literal literal{0, {}, comparison, 0};
      Literal opposite = literal;
      opposite.comparison = Opposite(comparison, &opposite.value);
      EXPECT_NE(Holds(literal, {}, state, world),
                Holds(opposite, {}, state, world))
          << value << " " << static_cast<int>(comparison);
    }
  }
}

}  // namespace
}  // namespace cell::rules
