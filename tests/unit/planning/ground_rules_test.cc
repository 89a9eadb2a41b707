#include "common/planning/ground_rules.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/parts/part_table.h"
#include "common/planning/ground_model.h"
#include "common/planning/planner.h"

namespace cell::planning {
namespace {

// Deictic references, `_`, conditional effects, overlapping rules.
constexpr char kTable[] = R"yaml(
types: {block: object, robot: object}
constants: {a: block, b: block, c: block, hand: robot}
predicates:
  On: {arguments: [block, block]}
  Clear: {arguments: [block]}
  Held: {arguments: [block]}
  Wet: {arguments: [block]}
actions:
  PickUp:
    arguments: {X: block}
    rules:
      - references: {Y: {type: block, such_that: ["On(X, Y)", not Wet(Y)]}}
        context: [Clear(X), not Held(_)]
        outcomes:
          - {probability: 0.7, effects: [Held(X), Clear(Y), "not On(X, Y)"]}
          - {probability: 0.2, effects: [Wet(X)]}
        noise: 0.1
  PutOn:
    arguments: {X: block, Y: block}
    rules:
      - context: [Held(X), Clear(Y)]
        outcomes:
          - probability: 1
            effects: ["On(X, Y)", not Held(X), not Clear(Y)]
        noise: 0
      - context: [Held(X), Wet(Y)]
        outcomes: [{probability: 1, effects: [not Held(X)]}]
        noise: 0
  Shake:
    arguments: {}
    rules:
      - context: ["On(_, _)"]
        outcomes:
          - probability: 0.5
            effects:
              - {each: {Z: block}, where: [Wet(Z)], then: [not Wet(Z)]}
              - Wet(a)
          - probability: 0.5
            effects: [not Wet(c)]
        noise: 0
goals:
  done: ["On(c, a)", not Wet(_)]
)yaml";

class GroundRulesTest : public testing::Test {
 protected:
  GroundRulesTest()
      : domain_(
            Domain::FromConfig(Config::Parse(kTable, "table"), PartTable())),
        rules_(RuleSet::FromDomain(domain_)) {}

  State Random(std::mt19937_64& random) const {
    State state(rules_->vocabulary().num_atoms());
    for (int atom = 0; atom < state.num_atoms(); ++atom) {
      if (random() % 3 == 0) state.Set(atom, Truth::kTrue);
    }
    return state;
  }

  using Distribution = std::map<std::vector<bool>, double>;

  /// Of the states after an action, by the rules themselves.
  Distribution ByRules(const cell::GroundAction& action,
                       const State& state) const {
    const Vocabulary& vocabulary = rules_->vocabulary();
    const auto covers =
        ApplicableRules(rules_->ActionOf(action), action.arguments, state,
                        vocabulary, Agent::kPerson);
    Distribution distribution;
    double rest = 1;
    if (covers.size() == 1) {
      const NdrRule& rule =
          rules_->ActionOf(action).rules[static_cast<size_t>(covers[0].rule)];
      for (const cell::Outcome& outcome : rule.outcomes) {
        distribution[AtomsOf(Apply(outcome, covers[0].binding, state,
                                   vocabulary))] += outcome.probability;
        rest -= outcome.probability;
      }
    }
    if (rest > 1e-9) distribution[AtomsOf(state)] += rest;
    return distribution;
  }

  Domain domain_;
  std::shared_ptr<const RuleSet> rules_;
};

TEST_F(GroundRulesTest, TheModelDoesWhatTheRulesSayInEveryState) {
  const RuleTask grounded =
      GroundRules(*rules_, *domain_.FindGoal("done"), Agent::kPerson,
                  State(rules_->vocabulary().num_atoms()));
  ASSERT_EQ(grounded.task.actions.size(), grounded.action_of.size());
  const GroundModel model(grounded.task);
  std::mt19937_64 random(3);
  int num_changes = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const State state = Random(random);
    const std::vector<uint64_t> packed = model.Pack(AtomsOf(state));
    Expansion expansion(model.num_words());
    model.Expand(packed, &expansion);
    std::map<cell::GroundAction, std::map<std::vector<uint64_t>, double>> found;
    for (const auto& choice : expansion.choices()) {
      const auto& action =
          grounded.action_of[static_cast<size_t>(choice.action)];
      EXPECT_FALSE(found.contains(action)) << "two rules apply at once";
      for (int i = 0; i < choice.num_outcomes; ++i) {
        const Bits next = expansion.state(choice.first_outcome + i);
        found[action][{next.begin(), next.end()}] +=
            expansion.probability(choice.first_outcome + i);
      }
    }
    for (const auto& action : rules_->GroundActions(Agent::kPerson)) {
      const Distribution expected = ByRules(action, state);
      if (!found.contains(action)) {
        EXPECT_EQ(expected.size(), 1u);
        EXPECT_TRUE(expected.contains(AtomsOf(state)));
        continue;
      }
      num_changes += expected.size() > 1;
      ASSERT_EQ(found[action].size(), expected.size());
      for (const auto& [next, probability] : expected) {
        EXPECT_NEAR(found[action][model.Pack(next)], probability, 1e-9);
      }
    }
    bool is_goal = true;
    for (const auto& literal : domain_.FindGoal("done")->literals) {
      is_goal &= MayHold(literal, {}, state, rules_->vocabulary());
    }
    EXPECT_EQ(model.IsGoal(packed), is_goal);
  }
  EXPECT_GT(num_changes, 100);
}

}  // namespace
}  // namespace cell::planning
