#include "common/rexd/guidance.h"

#include <gmock/gmock.h>

#include "common/planning/excuse.h"
#include "common/rexd/frozen_score.h"
#include "common/rexd/rule_alternatives.h"
#include "common/rexd/rule_task.h"
#include "common/rules/rule_error.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;
using testing::HasSubstr;

class GuidanceOnPlacing : public testing::Test {
 protected:
  Guidance Find(const NdrRules& rules) const {
    return FindGuidance(rules, task_, task_.initial, acts_);
  }
  Literal Of(const char* predicate, int object) const {
    return {*task_.world->symbols().Find(predicate),
            {{Term::Kind::kObject, object}},
            Comparison::kTrue,
            0};
  }
  RexdTask task_ = PlacingTask();
  std::vector<GroundAct> acts_ = GroundActs(*task_.world, task_.initial);
};

TEST_F(GuidanceOnPlacing, IsEmptyWhereThereIsAPlan) {
  EXPECT_TRUE(Find(task_.truth).empty());
}

TEST_F(GuidanceOnPlacing, NamesAnEffectThatNoRuleHas) {
  NdrRules rules = task_.truth;
  rules.rules.erase(rules.rules.begin());  // place(X)
  const Guidance guidance = Find(rules);
  EXPECT_EQ(ToText(guidance, *task_.world),
            "I know no action after which placed(red).\n"
            "I know no action after which placed(blue).\n");
  // Meanwhile the shelf can be closed.
  const Literal closed{
      *task_.world->symbols().Find("closed"), {}, Comparison::kTrue, 0};
  EXPECT_THAT(guidance.subgoals, testing::Contains(closed));
}

TEST_F(GuidanceOnPlacing, NamesAPreconditionThatCannotBeReached) {
  NdrRules rules = task_.truth;
  const int cover = *task_.world->symbols().Find("cover");
  rules.rules[0].context.push_back(
      {cover, {{Term::Kind::kVariable, 0}}, Comparison::kTrue, 0});
  // place(X) is believed to need that the book is a cover.
  const Guidance guidance = Find(rules);
  ASSERT_FALSE(guidance.blocked_acts.empty());
  EXPECT_EQ(guidance.blocked_acts[0].needs.symbol, cover);
  EXPECT_THAT(ToText(guidance, *task_.world),
              HasSubstr("I believe that place(red) would help, but that it "
                        "needs cover(red), which I cannot reach."));
}

TEST_F(GuidanceOnPlacing, EveryExcuseIsTold) {
  NdrRules rules = task_.truth;
  const int cover = *task_.world->symbols().Find("cover");
  rules.rules[0].context.push_back(
      {cover, {{Term::Kind::kVariable, 0}}, Comparison::kTrue, 0});
  const Guidance guidance = Find(rules);
  // Either book may be a cover, or be placed already.
  EXPECT_GT(guidance.excuses.size(), 1u);
  EXPECT_FALSE(guidance.further_excuses.empty());
  const std::string text = ToText(guidance, *task_.world);
  for (const auto& excuse : guidance.excuses) {
    for (const Literal& l : excuse) {
      const int object = l.terms[0].index;
      EXPECT_THAT(text, HasSubstr(task_.world->Show(l.symbol, {&object, 1})));
    }
  }
}

TEST_F(GuidanceOnPlacing, AnAlternativeSwapsTheWrongPrecondition) {
  NdrRules rules = task_.truth;
  // One book was placed: was it because it is not blue, or because it is a
  // book? The wrong guess leaves blue without a plan.
  const Literal is_placed_red{
      Literal::kSame,
      {{Term::Kind::kVariable, 0}, {Term::Kind::kObject, 0}},
      Comparison::kTrue,
      0};
  rules.rules[0].context[0] = is_placed_red;
  Guidance guidance;
  guidance.blocked_acts.push_back(
      {{rules.rules[0].action, {1}}, Literal{Literal::kSame, {}, {}, 0}});
  WorldState placed = task_.initial;
  World::Set(&placed,
             task_.world->PlaceOf(Of("placed", 0).symbol, std::vector<int>{0}),
             true);
  const std::vector<Experience> seen = {
      {task_.initial, {rules.rules[0].action, {0}}, placed}};
  const auto alternatives =
      RuleAlternatives(rules, *task_.world, task_.initial, guidance, seen);
  ASSERT_FALSE(alternatives.empty());
  EXPECT_EQ(alternatives[0].rules[0].context[0].symbol,
            *task_.world->symbols().Find("book"));
  for (const NdrRules& other : alternatives) {
    EXPECT_TRUE(
        Bind(other.rules[0], std::vector<int>{0}, task_.initial, *task_.world));
  }
}

TEST_F(GuidanceOnPlacing, AnAlternativeMaySpeakOfAnyObject) {
  // Placing red failed after the lid was placed, and there was no cover any
  // more. What of the two was it?
  NdrRules rules = task_.truth;
  const int placed = Of("placed", 0).symbol;
  const int cover = *task_.world->symbols().Find("cover");
  const int lid = *task_.world->FindObject("lid");
  rules.rules[0].context[0] = {
      placed, {{Term::Kind::kObject, lid}}, Comparison::kFalse, 0};
  const std::vector<int> of_lid = {lid};
  WorldState lid_is_placed = task_.initial;
  World::Set(&lid_is_placed, task_.world->PlaceOf(placed, of_lid), true);
  WorldState without_cover = lid_is_placed;
  World::Set(&without_cover, task_.world->PlaceOf(cover, of_lid), false);
  const GroundAct red{rules.rules[0].action, {0}};
  WorldState red_is_placed = task_.initial;
  World::Set(&red_is_placed, task_.world->PlaceOf(placed, red.arguments), true);
  const std::vector<Experience> seen = {{task_.initial, red, red_is_placed},
                                        {without_cover, red, without_cover}};

  Guidance guidance;
  guidance.blocked_acts.push_back({red, rules.rules[0].context[0]});
  const auto alternatives =
      RuleAlternatives(rules, *task_.world, lid_is_placed, guidance, seen);
  const Literal any_cover{cover, {{Term::Kind::kAny, 0}}, Comparison::kTrue, 0};
  EXPECT_TRUE(std::ranges::any_of(alternatives, [&](const NdrRules& other) {
    return other.rules[0].context[0] == any_cover;
  }));
  for (const NdrRules& other : alternatives) {
    const Rule& rule = other.rules[0];
    EXPECT_TRUE(Bind(rule, red.arguments, task_.initial, *task_.world));
    EXPECT_TRUE(Bind(rule, red.arguments, lid_is_placed, *task_.world));
    EXPECT_FALSE(Bind(rule, red.arguments, without_cover, *task_.world));
  }
}

/// The smallest number of changed atoms that helps, by trying all.
int SmallestChange(const planning::GroundTask& task) {
  const size_t n = task.atoms.size();
  for (int size = 0; size <= 3; ++size) {
    for (uint64_t set = 0; set < uint64_t{1} << n; ++set) {
      if (__builtin_popcountll(set) != size) continue;
      planning::GroundTask changed = task;
      for (size_t i = 0; i < n; ++i) {
        if (set >> i & 1) changed.initial[i] = !changed.initial[i];
      }
      if (FindExcuses(changed).is_solvable) return size;
    }
  }
  return 4;
}

TEST_F(GuidanceOnPlacing, ExcusesOfBrokenRulesAreMinimalAndHelp) {
  for (size_t broken = 0; broken < 2; ++broken) {
    NdrRules rules = task_.truth;
    rules.rules[broken].outcomes[0].changes.clear();
    const auto ground = GroundRuleTask(rules, task_, task_.initial, acts_);
    ASSERT_TRUE(ground) << ground.reason();
    const auto excuses = planning::FindExcuses(ground->task);
    ASSERT_FALSE(excuses.excuses.empty());
    EXPECT_EQ(static_cast<int>(excuses.excuses[0].changes.size()),
              SmallestChange(ground->task));
    planning::GroundTask changed = ground->task;
    for (const auto& change : excuses.excuses[0].changes) {
      changed.initial[static_cast<size_t>(change.literal.atom)] =
          change.literal.value;
    }
    EXPECT_TRUE(planning::FindExcuses(changed).is_solvable);
  }
}

TEST_F(GuidanceOnPlacing, WithoutTypesTheTrueRulesAskForThem) {
  const RexdTask untyped = WithoutTypes(task_);
  const int n = untyped.world->num_objects();
  EXPECT_EQ(GroundActs(*untyped.world, untyped.initial).size(),
            static_cast<size_t>(2 * n));
  const GroundAct act{*untyped.world->symbols().Find("place"),
                      {*untyped.world->FindObject("lid")}};
  EXPECT_FALSE(
      FindCoverage(untyped.truth, act, untyped.initial, *untyped.world));
}

TEST_F(GuidanceOnPlacing, APredicateThatRulesNeedCannotBeHidden) {
  EXPECT_THROW(WithoutPredicate(task_, "placed"), RuleError);
  EXPECT_THROW(WithoutPredicate(task_, "nothing"), RuleError);
}

TEST_F(GuidanceOnPlacing, RulesThatAreTrueScoreFully) {
  RexD learner(task_, {});
  RandomNumbers random(1);
  for (int i = 0; i < 6; ++i) {
    WorldState state = task_.initial;
    for (const size_t a : {0, 1, 2, 0, 2}) {
      const WorldState after =
          Simulate(task_.truth, *task_.world, acts_[a], state, &random);
      learner.Observe({state, acts_[a], after});
      state = after;
    }
  }
  const FrozenScore score = ScoreFrozen(task_, learner);
  // Any of the books placed, and not closed with one missing.
  EXPECT_EQ(score.num_states, 4);
  EXPECT_EQ(ScoreFrozen(task_, RexD(task_, {})).num_valid, 0);
}

}  // namespace
}  // namespace cell::rexd
