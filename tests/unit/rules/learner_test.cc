#include "common/rules/learning/learner.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "common/rules/simulation.h"
#include "tests/unit/rules/manipulation_domain.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

// Without chance: a lever opens the box beside it, unless that is locked; a key
// unlocks what it fits.
constexpr char kBoxRules[] = R"(
lever 1 primitive
key 1 primitive
box 1 primitive
beside 2 primitive
fits 2 primitive
locked 1 primitive
open 1 primitive
pull 1 action <-- lever(X)
turn 1 action <-- key(X)

Action: pull(X)
References: Y: beside(X, Y)
Preconditions: not locked(Y), not open(Y)
Effects:
  1: open(Y)
  0: noise

Action: pull(X)
References: Y: beside(X, Y)
Preconditions: open(Y)
Effects:
  1: not open(Y), locked(Y)
  0: noise

Action: turn(X)
References: Y: fits(X, Y)
Preconditions: locked(Y)
Effects:
  1: not locked(Y)
  0: noise
)";
constexpr char kBoxState[] =
    "lever(l) lever(m) lever(n) key(k) key(j) key(i) box(a) box(b) box(c) "
    "beside(l a) beside(m b) beside(n c) fits(k a) fits(j b) fits(i c) "
    "locked(a)";
constexpr char kBoxObjects[] = "lmnkjiabc";

struct Domain {
  Domain(const char* rules, const char* objects, const char* state)
      : truth(ParseRules(rules, "r")),
        world(std::make_shared<World>(truth.symbols, ObjectsFrom(objects))),
        initial(ParseState(state, "d", 1, *world)) {}

  ExperienceSet Draw(int number, uint64_t seed) const {
    return DrawExperiences(truth, world, initial, number, 20, seed);
  }

  NdrRules truth;
  std::shared_ptr<const World> world;
  WorldState initial;
};

Learner LearnFrom(const ExperienceSet& set,
                  const LearnerOptions& options = {}) {
  Learner learner(set.world, options);
  for (const Experience& e : set.experiences) learner.Add(e);
  learner.Learn();
  return learner;
}

TEST(Learner, LearnsADomainWithoutChance) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const NdrRules rules = LearnFrom(domain.Draw(80, seed)).Rules();
    int num_wrong = 0;
    for (const Experience& e : domain.Draw(300, 100 + seed).experiences) {
      const auto coverage = FindCoverage(rules, e.act, e.before, *domain.world);
      const bool is_right =
          coverage && coverage->rule->outcomes.size() == 1 &&
          Apply(coverage->rule->outcomes[0], coverage->binding, e.before,
                *domain.world) == e.after;
      num_wrong += !is_right;
    }
    EXPECT_EQ(num_wrong, 0) << "seed " << seed << "\n" << ToText(rules);
  }
}

TEST(Learner, FindsProbabilitiesOfANoisyDomain) {
  const Domain domain(kManipulationRules, kManipulationObjects,
                      kManipulationState);
  const NdrRules rules = LearnFrom(domain.Draw(300, 1)).Rules();
  const ExperienceSet test = domain.Draw(300, 77);
  const LearnerOptions options;
  double learned = 0;
  for (const Experience& e : test.experiences) {
    learned += LogLikelihood(rules, *domain.world, e, options);
  }
  // The entropy of the outcomes is about 0.5; a wrong outcome costs 25.
  EXPECT_GT(learned / 300, -1.0);
}

TEST(Learner, CoversNoExperienceTwice) {
  const Domain domain(kManipulationRules, kManipulationObjects,
                      kManipulationState);
  const ExperienceSet set = domain.Draw(100, 4);
  const NdrRules rules = LearnFrom(set).Rules();
  for (const Experience& e : set.experiences) {
    int num_covering = 0;
    for (const Rule& rule : rules.rules) {
      num_covering += rule.action == e.act.action &&
                      Bind(rule, e.act.arguments, e.before, *domain.world);
    }
    EXPECT_LE(num_covering, 1);
  }
}

TEST(Learner, RulesCountTheExperiencesThatTheyCover) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  const ExperienceSet set = domain.Draw(40, 4);
  const Learner learner = LearnFrom(set);
  const NdrRules rules = learner.Rules();
  const std::vector<int> counts = learner.RuleCounts();
  ASSERT_EQ(counts.size(), rules.rules.size());
  std::vector<int> expected(counts.size(), 0);
  for (const Experience& e : set.experiences) {
    const auto coverage = FindCoverage(rules, e.act, e.before, *domain.world);
    if (coverage) ++expected[coverage->rule - rules.rules.data()];
  }
  EXPECT_EQ(counts, expected);
}

TEST(Learner, EqualSeedsGiveEqualRulesAndSoDoesOrderOfOtherActions) {
  const Domain domain(kManipulationRules, kManipulationObjects,
                      kManipulationState);
  ExperienceSet set = domain.Draw(60, 9);
  const std::string first = ToText(LearnFrom(set).Rules());
  EXPECT_EQ(ToText(LearnFrom(set).Rules()), first);
  // Experiences of one action keep their order among themselves.
  std::stable_sort(set.experiences.begin(), set.experiences.end(),
                   [](const Experience& a, const Experience& b) {
                     return a.act.action > b.act.action;
                   });
  EXPECT_EQ(ToText(LearnFrom(set).Rules()), first);
}

TEST(Learner, RenamingObjectsAndPredicatesChangesNothingButNames) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  ExperienceSet set = domain.Draw(60, 3);
  const std::string rules = ToText(LearnFrom(set).Rules());
  const auto renamed = [](std::string text) {
    for (size_t at = 0; (at = text.find("open", at)) != std::string::npos;) {
      text.replace(at, 4, "ajar");
    }
    return text;
  };
  const auto symbols = SymbolsFrom(renamed(domain.world->symbols().ToText()));
  set.world = std::make_shared<World>(symbols, ObjectsFrom("zyxwvutsr"));
  EXPECT_EQ(ToText(LearnFrom(set).Rules()), renamed(rules));
}

TEST(Learner, GoesOnFromItsRulesWhenAnExperienceIsAdded) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  const ExperienceSet set = domain.Draw(81, 2);
  Learner learner(set.world, {});
  for (size_t i = 0; i < 80; ++i) learner.Add(set.experiences[i]);
  learner.Learn();
  const int action = set.experiences[80].act.action;
  const int num_steps = learner.SearchOf(action)->num_steps();
  const std::string before = ToText(learner.Rules());
  learner.Add(set.experiences[80]);
  learner.Learn();
  // The rules explain it: no operator applies, and the same rules remain.
  EXPECT_EQ(learner.SearchOf(action)->num_steps(), num_steps);
  EXPECT_EQ(ToText(learner.Rules()), before);
}

TEST(Learner, ScoresStayBetweenThatOfTheDefaultRulesAndZero) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  const ExperienceSet set = domain.Draw(60, 6);
  Learner learner(set.world, {});
  for (const Experience& e : set.experiences) {
    learner.Add(e);
    learner.Learn();
    EXPECT_LE(learner.Score(), 1e-9);
  }
  // The three rules have 13 literals; the default rules alone would cost 25
  // for each experience.
  EXPECT_GT(learner.Score(), -30);
}

TEST(Learner, OfContradictoryExperiencesLearnsBothOutcomes) {
  const ExperienceSet set =
      ExperiencesFrom("press 1 action\nlit 1 primitive\nlamp 1 primitive\n",
                      "lamp(a)\npress(a)\nlamp(a) lit(a)\n"
                      "lamp(a)\npress(a)\nlamp(a)\n");
  const NdrRules rules = LearnFrom(set).Rules();
  ASSERT_EQ(rules.rules.size(), 1u);
  ASSERT_EQ(rules.rules[0].outcomes.size(), 2u);
  EXPECT_DOUBLE_EQ(rules.rules[0].outcomes[0].probability, 0.5);
}

TEST(Learner, RefusesExperiencesOfAnotherWorld) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  const Domain other(kManipulationRules, kManipulationObjects,
                     kManipulationState);
  Learner learner(domain.world, {});
  EXPECT_THROW(learner.Add(other.Draw(1, 1).experiences[0]),
               std::invalid_argument);
}

TEST(HeldOut, IsHighForADomainWithoutChance) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  EXPECT_GT(HeldOutLogLikelihood(domain.Draw(60, 5), {}, 5), -0.5);
}

TEST(HeldOut, WantsTwoFoldsAtLeast) {
  const Domain domain(kBoxRules, kBoxObjects, kBoxState);
  EXPECT_THROW((void)HeldOutLogLikelihood(domain.Draw(5, 5), {}, 1),
               std::invalid_argument);
  EXPECT_THROW((void)HeldOutLogLikelihood(domain.Draw(5, 5), {}, 6),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell::rules
