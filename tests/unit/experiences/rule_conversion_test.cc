#include "common/experiences/rule_conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/rules/rule_text.h"
#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

using testing::HasSubstr;

rules::Rule RuleFrom(const std::string& text, const RuleWorld& world) {
  return rules::ParseRules(world.world()->symbols().ToText() + text, "r")
      .rules.at(0);
}

std::string RefusalOf(const std::string& text, const RuleWorld& world) {
  return ToNdrRule(RuleFrom(text, world), world).reason();
}

/// Rules with random literals and, half of them, a reference.
class RandomRules {
 public:
  RandomRules(const rules::World& world, uint64_t seed)
      : world_(world), random_(seed) {}

  rules::Rule Next() {
    rules::Rule rule;
    const std::vector<int> actions = world_.symbols().Actions();
    rule.action = actions[Below(actions.size())];
    const int arity = world_.symbols()[rule.action].arity;
    for (int i = 0; i < arity; ++i) rule.arguments.push_back(i ? "Y" : "X");
    int variables = arity;
    if (Below(2) == 0) {
      rule.references.push_back({"R", {AnyLiteral(arity + 1)}});
      rule.references[0].literals[0].terms[0] = {rules::Term::Kind::kVariable,
                                                 arity};
      ++variables;
    }
    for (size_t i = Below(3); i > 0; --i) {
      rule.context.push_back(AnyLiteral(variables));
    }
    rules::Outcome outcome{0.75, {}};
    while (outcome.changes.empty()) {
      rules::Literal change = AnyLiteral(variables);
      std::erase_if(change.terms, [](const rules::Term& t) {
        return t.kind == rules::Term::Kind::kAny;
      });
      if (static_cast<int>(change.terms.size()) ==
          world_.symbols()[change.symbol].arity) {
        outcome.changes.push_back(change);
      }
    }
    if (Below(2) == 0) {
      const rules::Literal change = AnyLiteral(variables + 1);
      const bool is_ground =
          std::ranges::none_of(change.terms, [](const rules::Term& t) {
            return t.kind == rules::Term::Kind::kAny;
          });
      if (is_ground) {
        outcome.each.push_back({"P", {AnyLiteral(variables + 1)}, change});
      }
    }
    rule.outcomes = {outcome};
    rule.noise = 0.25;
    return rule;
  }

 private:
  size_t Below(size_t end) { return random_() % end; }

  rules::Literal AnyLiteral(int variables) {
    rules::Literal literal;
    do {
      literal.symbol = static_cast<int>(Below(world_.symbols().all().size()));
    } while (world_.symbols()[literal.symbol].kind !=
             rules::Symbol::Kind::kPrimitive);
    for (int i = 0; i < world_.symbols()[literal.symbol].arity; ++i) {
      literal.terms.push_back(AnyTerm(variables));
    }
    literal.comparison =
        Below(2) == 0 ? rules::Comparison::kTrue : rules::Comparison::kFalse;
    return literal;
  }

  rules::Term AnyTerm(int variables) {
    const size_t kind = Below(6);
    if (kind == 0) return {rules::Term::Kind::kAny, 0};
    if (kind == 1) {
      return {
          rules::Term::Kind::kObject,
          static_cast<int>(Below(static_cast<size_t>(world_.num_constants())))};
    }
    return {rules::Term::Kind::kVariable,
            static_cast<int>(Below(static_cast<size_t>(variables)))};
  }

  const rules::World& world_;
  std::mt19937_64 random_;
};

TEST(RuleConversion, StatesSurviveTheWayToTheWorldAndBack) {
  const CranfieldRules task;
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const State state = task.RandomState(0.5, random);
    EXPECT_EQ(task.world.FromWorld(task.world.ToWorld(state)), state);
  }
}

TEST(RuleConversion, WhatIsUnknownBeforeOrAfterHasNotChanged) {
  const CranfieldRules task;
  const auto action =
      task.Ground("PlaceRoundPeg", {"round_peg_1", "base.round_1"});
  const State before =
      task.With(task.Start(), {"Free(base.shaft)"}, Truth::kUnknown);
  const State after = task.With(task.Start(), {"Clear(head)"}, Truth::kUnknown);
  const auto experience = task.world.ToExperience(before, action, after);
  EXPECT_EQ(experience.before, experience.after);
  EXPECT_EQ(task.world.FromWorld(experience.before), task.Start());
  EXPECT_EQ(task.world.FromWorld(experience.act), action);
}

/// The same coverage and the same successors, for every action in every state.
TEST(RuleConversion, AConvertedRuleMeansTheSame) {
  const CranfieldRules task;
  const rules::World& world = *task.world.world();
  RandomRules random_rules(world, 7);
  std::mt19937_64 random(8);
  int num_converted = 0;
  int num_covered = 0;
  int num_with_each = 0;
  for (int i = 0; i < 40000; ++i) {
    const rules::Rule rule = random_rules.Next();
    const auto converted = ToNdrRule(rule, task.world);
    if (!converted) continue;
    ++num_converted;
    Action action =
        task.domain
            ->actions()[static_cast<size_t>(task.world.ActionOf(rule.action))];
    action.rules = {*converted};
    const State state = task.RandomState(i % 2 == 0 ? 0.1 : 0.7, random);
    const rules::WorldState world_state = task.world.ToWorld(state);
    for (const rules::GroundAct& act : rules::GroundActs(world, world_state)) {
      if (act.action != rule.action) continue;
      const auto bound = rules::Bind(rule, act.arguments, world_state, world);
      const auto applicable =
          ApplicableRules(action, task.world.FromWorld(act).arguments, state,
                          task.domain->vocabulary(), action.agents.front());
      ASSERT_EQ(applicable.size(), bound ? 1U : 0U)
          << rules::ToText(rule, world.symbols())
          << world.Show(act.action, act.arguments);
      if (!bound) continue;
      ++num_covered;
      num_with_each += rule.outcomes[0].each.empty() ? 0 : 1;
      EXPECT_EQ(Apply(converted->outcomes[0], applicable[0].binding, state,
                      task.domain->vocabulary()),
                task.world.FromWorld(
                    rules::Apply(rule.outcomes[0], *bound, world_state, world)))
          << rules::ToText(rule, world.symbols());
    }
  }
  EXPECT_GT(num_converted, 150);
  EXPECT_GT(num_covered, 100);
  EXPECT_GT(num_with_each, 20);
}

TEST(RuleConversion, ReferencesGetTheTypeThatTheirLiteralsGiveThem) {
  const CranfieldRules task;
  const auto rule = ToNdrRule(
      RuleFrom("Action: PlaceSeparator(X)\n"
               "References: P: shaft(P), PegInHole(P, base.shaft)\n"
               "Preconditions: Clear(P)\nEffects:\n  1: SeparatorPlaced(X)\n"
               "  0: noise\n",
               task.world),
      task.world);
  ASSERT_TRUE(rule) << rule.reason();
  EXPECT_EQ(task.domain->vocabulary().types().name(
                rule->references.at(0).variable.type),
            "shaft");
}

TEST(RuleConversion, RefusesWhatTheDomainHasNoWordsFor) {
  const CranfieldRules task;
  const std::string end = "\nEffects:\n  1: Clear(X)\n  0: noise\n";
  EXPECT_THAT(
      RefusalOf("Action: PlaceRoundPeg(X, Y)\nPreconditions: X != Y" + end,
                task.world),
      HasSubstr("same"));
  EXPECT_THAT(
      RefusalOf("Action: PlaceSeparator(X)\nPreconditions: Horizontal(X)" + end,
                task.world),
      HasSubstr("a rule of PlaceSeparator: 'Horizontal(X)' can never hold"));
  EXPECT_THAT(
      RefusalOf("Action: PutDown(X, Y)\nPreconditions: not Horizontal(X)" + end,
                task.world),
      HasSubstr("'not Horizontal(X)' is defined for some"));
}

}  // namespace
}  // namespace cell
