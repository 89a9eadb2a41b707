#include "common/rules/rule_text.h"

#include <gmock/gmock.h>

#include "common/rules/data_text.h"
#include "common/rules/learning/learner.h"
#include "common/rules/rule_error.h"
#include "common/rules/simulation.h"
#include "tests/unit/rules/manipulation_domain.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

using testing::HasSubstr;

constexpr char kDeclarations[] =
    "tray 0 constant\nput 2 action\nfull 1 primitive\non 2 primitive\n"
    "size 1 primitive integers\nempty 1 conjunction <-- -full(X)\n";

std::string RuleErrorOf(const std::string& rule) {
  try {
    ParseRules(kDeclarations + rule, "r");
  } catch (const RuleError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RuleText, ReadsAsInThePaper) {
  const std::string rule =
      "Action: put(X, Y)\n"
      "References: Z: on(Z, X), Z != Y; U: on(_, U), not full(U)\n"
      "Preconditions: not full(tray), size(Y) >= -3, size(X) != 2\n"
      "Effects:\n"
      "  0.625: on(X, Y), not on(X, Z), size(X) = 4\n"
      "  0.25: nothing\n"
      "  0.125: noise\n";
  const NdrRules rules = ParseRules(kDeclarations + rule, "r");
  ASSERT_EQ(rules.rules.size(), 1u);
  EXPECT_EQ(ToText(rules.rules[0], *rules.symbols), rule);
  EXPECT_EQ(rules.rules[0].num_literals(), 10);
}

constexpr char kEachRule[] =
    "Action: put(X, Y)\n"
    "Preconditions: full(X)\n"
    "Effects:\n"
    "  0.75: on(X, Y)\n"
    "    each P: not full(P) if on(P, X), not on(P, Y)\n"
    "    each P: on(P, X)\n"
    "  0.25: noise\n";

TEST(RuleText, ReadsChangesOfEachObject) {
  const NdrRules rules =
      ParseRules(std::string(kDeclarations) + kEachRule, "r");
  ASSERT_EQ(rules.rules.size(), 1u);
  EXPECT_EQ(ToText(rules.rules[0], *rules.symbols), kEachRule);
  EXPECT_EQ(rules.rules[0].num_literals(), 6);
  const Outcome& outcome = rules.rules[0].outcomes.at(0);
  ASSERT_EQ(outcome.each.size(), 2u);
  EXPECT_EQ(outcome.each[0].where.size(), 2u);
  EXPECT_EQ(outcome.each[0].change.terms[0].index, 2);
}

TEST(RuleText, RefusesWrongChangesOfEachObject) {
  const std::string rule = kEachRule;
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = rule;
    return RuleErrorOf(text.replace(text.find(part), part.size(), other));
  };
  EXPECT_THAT(with("each P: on(P, X)", "each X: on(X, X)"),
              HasSubstr("two variables 'X'"));
  EXPECT_THAT(with("each P: on(P, X)", "each P: on(Q, X)"),
              HasSubstr("no variable 'Q'"));
  EXPECT_THAT(with("each P: on(P, X)", "each P: empty(P)"),
              HasSubstr("'empty' is derived"));
  EXPECT_THAT(with("0.75: on(X, Y)\n", ""), HasSubstr("follows an effect"));
}

TEST(RuleText, RefusesLiteralsThatNeverHoldTogether) {
  const auto with = [](const std::string& conditions,
                       const std::string& changes) {
    return RuleErrorOf("Action: put(X, Y)\nPreconditions: " + conditions +
                       "\nEffects:\n  1: " + changes + "\n  0: noise\n");
  };
  EXPECT_THAT(with("full(X)", "full(Y), on(X, Y), not full(Y)"),
              HasSubstr("r:10: 'not full(Y)' contradicts 'full(Y)'"));
  EXPECT_THAT(with("full(X)", "size(X) = 1, size(X) = 2"),
              HasSubstr("'size(X) = 2' contradicts 'size(X) = 1'"));
  for (const char* conditions :
       {"not full(X), full(X)", "on(X, Y), not on(X, _)",
        "size(X) <= 2, size(X) >= 3", "size(X) != 2, size(X) = 2",
        "X = Y, X != Y"}) {
    EXPECT_THAT(with(conditions, "full(X)"), HasSubstr("r:8: ")) << conditions;
  }
  EXPECT_EQ(with("full(X), not full(Y), on(X, _), not on(X, Y), size(X) >= 2, "
                 "size(X) != 3, size(X) <= 4, size(Y) = 3",
                 "full(Y), not full(X), size(X) = 1, size(Y) = 2"),
            "no error");
}

TEST(RuleText, SaysThatAnActionIsNoPredicate) {
  EXPECT_THAT(RuleErrorOf("Action: put(X, Y)\nPreconditions: put(X, Y)\n"),
              HasSubstr("r:8: 'put' is an action; expected a predicate"));
  EXPECT_THAT(RuleErrorOf("held 1 conjunction <-- put(X Y)\n"),
              HasSubstr("'put' is an action"));
  EXPECT_THAT(RuleErrorOf("Action: put(X, Y)\nPreconditions: fall(X)\n"),
              HasSubstr("'fall'; did you mean 'full'?"));
}

TEST(RuleText, MayBeginWithAByteOrderMark) {
  const NdrRules rules =
      ParseRules(std::string("\xef\xbb\xbf") + kDeclarations + kEachRule, "r");
  EXPECT_EQ(rules.rules.size(), 1u);
}

TEST(RuleText, ChangesEachObjectByTheStateBefore) {
  const NdrRules rules = ParseRules(
      "put 1 action\nfull 1 primitive\n"
      "Action: put(X)\nPreconditions: none\nEffects:\n"
      "  1: full(X)\n    each P: not full(P) if full(P)\n"
      "    each P: full(P) if not full(P), full(X)\n  0: noise\n",
      "r");
  const World world(rules.symbols, {"a", "b", "c"});
  WorldState before = ParseState("full(a) full(b)", "d", 1, world);
  before.is_present.assign(3, 1);
  const Outcome& outcome = rules.rules[0].outcomes[0];
  EXPECT_EQ(ToText(Apply(outcome, std::vector{0}, before, world), world),
            "full(a) full(c)");
  // c is absent: nothing becomes true of it.
  WorldState absent = before;
  absent.is_present[2] = 0;
  EXPECT_EQ(ToText(Apply(outcome, std::vector{0}, absent, world), world),
            "full(a)");
}

TEST(RuleText, IsReadBackExactlyForLearnedRules) {
  const NdrRules truth = ParseRules(kManipulationRules, "r");
  const auto world =
      std::make_shared<World>(truth.symbols, ObjectsFrom(kManipulationObjects));
  const WorldState initial = ParseState(kManipulationState, "d", 1, *world);
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const ExperienceSet set =
        DrawExperiences(truth, world, initial, 40, 10, seed);
    Learner learner(world, {});
    for (const Experience& e : set.experiences) learner.Add(e);
    learner.Learn();
    const NdrRules rules = learner.Rules();
    ASSERT_FALSE(rules.rules.empty());
    const NdrRules again = ParseRules(ToText(rules), "r");
    EXPECT_EQ(again.rules, rules.rules);
    EXPECT_EQ(*again.symbols, *rules.symbols);
  }
}

TEST(RuleText, ProbabilitiesCanBeShort) {
  NdrRules rules = ParseRules(std::string(kDeclarations) +
                                  "Action: put(X, Y)\nPreconditions: none\n"
                                  "Effects:\n  1: nothing\n",
                              "r");
  rules.rules[0].outcomes[0].probability = 2.0 / 3;
  rules.rules[0].noise = 1.0 / 3;
  EXPECT_THAT(ToText(rules.rules[0], *rules.symbols, 2),
              HasSubstr("  0.67: nothing\n  0.33: noise\n"));
}

TEST(RuleText, TinyProbabilitiesAreReadBack) {
  NdrRules rules = ParseRules(std::string(kDeclarations) +
                                  "Action: put(X, Y)\nPreconditions: none\n"
                                  "Effects:\n  1: nothing\n",
                              "r");
  rules.rules[0].outcomes[0].probability = 1 - 1e-9;
  rules.rules[0].noise = 1e-9;
  EXPECT_EQ(ParseRules(ToText(rules), "r").rules, rules.rules);
}

TEST(RuleText, ErrorsNameFileAndLineAndWhatIsRight) {
  const std::string head = "Action: put(X, Y)\n";  // line 7
  EXPECT_THAT(RuleErrorOf("Action: putt(X, Y)\n"),
              HasSubstr("r:7: there is no action 'putt'; did you mean 'put'?"));
  EXPECT_THAT(RuleErrorOf("Action: put(X)\n"),
              HasSubstr("r:7: 'put' has 2 arguments, not 1"));
  EXPECT_THAT(RuleErrorOf("Action: put(X, X)\n"),
              HasSubstr("there are two variables 'X'"));
  EXPECT_THAT(RuleErrorOf(head + "Preconditions: fool(X)\n"),
              HasSubstr("r:8: there is no predicate or function 'fool'"));
  EXPECT_THAT(RuleErrorOf(head + "Preconditions: full(Z)\n"),
              HasSubstr("r:8: there is no variable 'Z' in this rule"));
  EXPECT_THAT(RuleErrorOf(head + "Preconditions: full(box)\n"),
              HasSubstr("r:8: there is no constant 'box'"));
  EXPECT_THAT(RuleErrorOf(head + "Preconditions: full(X, Y)\n"),
              HasSubstr("r:8: 'full' has 1 arguments, not 2"));
  EXPECT_THAT(RuleErrorOf(head + "Preconditions: size(X)\n"),
              HasSubstr("r:8: 'size' is a function"));
  EXPECT_THAT(RuleErrorOf(head + "Effects:\n  1: empty(X)\n"),
              HasSubstr("r:9: 'empty' is derived: no effect can change it"));
  EXPECT_THAT(RuleErrorOf(head + "Effects:\n  1: full(_)\n"),
              HasSubstr("r:9: '_' can stand in a condition"));
  EXPECT_THAT(RuleErrorOf(head + "Effects:\n  1.5: full(X)\n"),
              HasSubstr("r:9: '1.5' is no probability"));
  EXPECT_THAT(
      RuleErrorOf(head + "Effects:\n  0.5: full(X)\n  0.4: noise\n"),
      HasSubstr("r:7: the probabilities of this rule's effects sum to 0.9"));
  EXPECT_THAT(RuleErrorOf(head + "Effects:\nPreconditions: none\n"),
              HasSubstr("r:9: the order is References:, Preconditions:"));
  EXPECT_THAT(RuleErrorOf(head + "  1: full(X)\n"),
              HasSubstr("r:8: expected References:"));
}

}  // namespace
}  // namespace cell::rules
