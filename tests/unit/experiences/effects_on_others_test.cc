#include "common/experiences/effects_on_others.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_lessons.h"
#include "common/rules/rule_text.h"
#include "tests/unit/bench_domain.h"

namespace cell {
namespace {

// A lid covers what is in the holes, and the empty holes. A bolt that lies
// aside stays clear, and so does the lid.
constexpr char kLidDomain[] = R"yaml(
types: {part: object, bolt: part, lid: part, hole: object}
constants: {bolt_1: bolt, bolt_2: bolt, bolt_3: bolt, lid: lid,
            hole_1: hole, hole_2: hole, hole_3: hole}
predicates:
  In: {arguments: [bolt, hole]}
  Closed: {arguments: [lid]}
  Clear: {arguments: [part]}
  Free: {arguments: [hole]}
actions:
  Close:
    arguments: {X: lid}
    rules:
      - context: [not Closed(_)]
        outcomes:
          - probability: 1
            effects:
              - Closed(X)
              - {each: {P: bolt}, where: ["In(P, _)"], then: [not Clear(P)]}
              - {each: {Y: hole}, where: [], then: [not Free(Y)]}
        noise: 0
  Open:
    arguments: {X: lid}
    rules:
      - context: [Closed(X)]
        outcomes:
          - probability: 1
            effects:
              - not Closed(X)
              - {each: {P: bolt}, where: ["In(P, _)"], then: [Clear(P)]}
              - {each: {Y: hole}, where: ["not In(_, Y)"], then: [Free(Y)]}
        noise: 0
goals:
  done: [Closed(lid)]
)yaml";

class LidExperiences {
 public:
  explicit LidExperiences(uint64_t seed) : random_(seed) {}

  const RuleWorld& world() const { return world_; }
  const BenchDomain& bench() const { return bench_; }

  /// Bolts in some holes, under the lid or not.
  State AnyState(bool is_closed) {
    std::set<std::string> is_true = {"Clear(lid)"};
    if (is_closed) is_true.insert("Closed(lid)");
    for (const std::string number : {"1", "2", "3"}) {
      const std::string hole = "hole_" + number;
      const std::string bolt = "bolt_" + number;
      const bool is_in = random_() % 2 == 0;
      if (is_in) is_true.insert("In(" + bolt + ", " + hole + ")");
      if (!is_in && !is_closed) is_true.insert("Free(" + hole + ")");
      if (!is_in || !is_closed) is_true.insert("Clear(" + bolt + ")");
    }
    return bench_.StateOf(is_true);
  }

  static State Do(const std::vector<cell::Action>& actions,
                  const GroundAction& action, const State& state,
                  const Vocabulary& vocabulary) {
    const cell::Action& lifted = actions[static_cast<size_t>(action.action)];
    const auto rules = ApplicableRules(lifted, action.arguments, state,
                                       vocabulary, Agent::kPerson);
    if (rules.size() != 1) return state;
    const NdrRule& rule = lifted.rules[static_cast<size_t>(rules[0].rule)];
    return Apply(rule.outcomes.at(0), rules[0].binding, state, vocabulary);
  }

  std::vector<rules::Experience> Draw(int number) {
    std::vector<rules::Experience> experiences;
    for (int i = 0; i < number; ++i) {
      const bool is_closed = i % 2 == 1;
      const GroundAction action =
          bench_.Action(is_closed ? "Open" : "Close", {"lid"});
      const State before = AnyState(is_closed);
      experiences.push_back(world_.ToExperience(
          before, action,
          Do(world_.actions(), action, before, world_.vocabulary())));
    }
    return experiences;
  }

 private:
  BenchDomain bench_{kLidDomain};
  RuleWorld world_{
      std::make_shared<const Vocabulary>(bench_.domain.vocabulary()),
      bench_.domain.actions()};
  std::mt19937_64 random_;
};

TEST(EffectsOnOthers, AreThoseOfTheRulesThatMadeTheExperiences) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    LidExperiences lid(seed);
    const auto rules = LearnRules(lid.Draw(40), {}, lid.world());
    const auto actions = WithLearnedRules(rules, lid.world());
    ASSERT_TRUE(actions) << actions.reason();
    for (int i = 0; i < 50; ++i) {
      const bool is_closed = i % 2 == 1;
      const State state = lid.AnyState(is_closed);
      const auto action =
          lid.bench().Action(is_closed ? "Open" : "Close", {"lid"});
      const Vocabulary& vocabulary = lid.world().vocabulary();
      EXPECT_EQ(
          LidExperiences::Do(*actions, action, state, vocabulary),
          LidExperiences::Do(lid.world().actions(), action, state, vocabulary))
          << rules::ToText(rules);
    }
  }
}

rules::Rule CloseRule(const RuleWorld& world) {
  return rules::ParseRules(world.world()->symbols().ToText() +
                               "Action: Close(X)\n"
                               "Preconditions: not Closed(_)\n"
                               "Effects:\n  1: Closed(X)\n  0: noise\n",
                           "r")
      .rules.at(0);
}

TEST(EffectsOnOthers, ReadAsConditionsOfAnyObject) {
  LidExperiences lid(7);
  rules::Rule rule = CloseRule(lid.world());
  AddEffectsOnOthers(lid.Draw(40), {}, lid.world(), &rule);
  EXPECT_EQ(rules::ToText(rule, lid.world().world()->symbols()),
            "Action: Close(X)\n"
            "Preconditions: not Closed(_)\n"
            "Effects:\n"
            "  1: Closed(X)\n"
            "    each P: not Clear(P) if In(P, _)\n"
            "    each P: not Free(P)\n"
            "  0: noise\n");
}

TEST(EffectsOnOthers, NeedTwoExperiences) {
  LidExperiences lid(7);
  std::vector<rules::Experience> one = lid.Draw(1);
  rules::Rule rule = CloseRule(lid.world());
  AddEffectsOnOthers(one, {}, lid.world(), &rule);
  EXPECT_TRUE(rule.outcomes.at(0).each.empty());
  one.push_back(one.front());
  AddEffectsOnOthers(one, {}, lid.world(), &rule);
  EXPECT_FALSE(rule.outcomes.at(0).each.empty());
}

/// One wrong sensing among many does not hide an effect, and makes none.
TEST(EffectsOnOthers, AreRobustAgainstASingleContradiction) {
  LidExperiences lid(9);
  std::vector<rules::Experience> experiences = lid.Draw(200);
  const rules::World& world = *lid.world().world();
  const int clear = *world.symbols().Find("Clear");
  const int place = world.PlaceOf(clear, std::vector{*world.FindObject("lid")});
  rules::World::Set(&experiences[0].after, place, false);
  const int in = *world.symbols().Find("In");
  for (const std::string number : {"1", "2", "3"}) {
    const int bolt = *world.FindObject("bolt_" + number);
    const int hole = *world.FindObject("hole_" + number);
    rules::Experience& e = experiences[2];
    if (!rules::World::Get(e.before,
                           world.PlaceOf(in, std::vector{bolt, hole}))) {
      continue;
    }
    rules::World::Set(&e.after, world.PlaceOf(clear, std::vector{bolt}), true);
    break;
  }
  rules::Rule rule = CloseRule(lid.world());
  AddEffectsOnOthers(experiences, {}, lid.world(), &rule);
  const std::string text = rules::ToText(rule, world.symbols());
  EXPECT_NE(text.find("each P: not Clear(P) if In(P, _)\n"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("lid(P)"), std::string::npos) << text;
}

}  // namespace
}  // namespace cell
