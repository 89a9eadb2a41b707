#include <gmock/gmock.h>

#include <cmath>

#include "common/rules/learning/induced.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

constexpr char kLampSymbols[] = R"(
press 1 action
lit 1 primitive
warm 1 primitive
room 1 primitive
)";

/// All experiences of the only action.
FeatureTable TableOf(const ExperienceSet& set) {
  FeatureTable table(set.world, 0);
  for (const Experience& e : set.experiences) table.Add(e);
  return table;
}

Induced InduceFrom(const std::string& data,
                   const LearnerOptions& options = {}) {
  FeatureTable table = TableOf(ExperiencesFrom(kLampSymbols, data));
  ChangeLifter lifter(&table);
  return InduceOutcomes({}, BitSet(table.size(), true), options, &table,
                        &lifter);
}

InducedOutcome CoveringOnly(int size, std::initializer_list<int> members) {
  InducedOutcome outcome{{}, BitSet(size), 0};
  for (const int e : members) outcome.covers.Add(e);
  return outcome;
}

constexpr char kLights[] = "room(a)\npress(a)\nroom(a) lit(a)\n";
constexpr char kStays[] = "room(a)\npress(a)\nroom(a)\n";

TEST(LearnParameters, CountsIfOutcomesDoNotOverlap) {
  Induced induced;
  induced.outcomes = {CoveringOnly(10, {0, 1, 2, 3, 4, 5}),
                      CoveringOnly(10, {6, 7, 8})};
  LearnParameters(BitSet(10, true), 1e-10, &induced);
  EXPECT_DOUBLE_EQ(induced.outcomes[0].probability, 0.6);
  EXPECT_DOUBLE_EQ(induced.outcomes[1].probability, 0.3);
  EXPECT_DOUBLE_EQ(induced.noise, 0.1);
  EXPECT_NEAR(induced.log_likelihood,
              6 * std::log(0.6) + 3 * std::log(0.3) + std::log(0.1 * 1e-10),
              1e-6);
}

TEST(LearnParameters, MaximisesTheLikelihoodIfOutcomesOverlap) {
  Induced induced;
  induced.outcomes = {CoveringOnly(10, {0, 1, 2, 3, 4, 5, 6}),
                      CoveringOnly(10, {5, 6, 7, 8, 9})};
  const BitSet all(10, true);
  LearnParameters(all, 1e-10, &induced);
  // Five only by the first, three only by the second, two by both: 5/8, 3/8.
  EXPECT_NEAR(induced.outcomes[0].probability, 0.625, 1e-3);
  EXPECT_NEAR(induced.outcomes[1].probability, 0.375, 1e-3);
  const double best = 5 * std::log(0.625) + 3 * std::log(0.375);
  EXPECT_NEAR(induced.log_likelihood, best, 1e-6);
}

TEST(InduceOutcomes, HasOneOutcomeForEachDistinctChange) {
  const Induced induced =
      InduceFrom(std::string(kLights) + kLights + kLights + kStays);
  ASSERT_EQ(induced.outcomes.size(), 2u);
  EXPECT_EQ(induced.outcomes[0].changes.size(), 1u);
  EXPECT_DOUBLE_EQ(induced.outcomes[0].probability, 0.75);
  EXPECT_TRUE(induced.outcomes[1].changes.empty());
  EXPECT_DOUBLE_EQ(induced.noise, 0);
  EXPECT_EQ(induced.num_literals, 1);
}

TEST(InduceOutcomes, OneOutcomeExplainsChangesThatWereThereBefore) {
  // {lit, warm} explains {lit} where it was warm already.
  const Induced induced = InduceFrom(
      "room(a)\npress(a)\nlit(a) warm(a) room(a)\n"
      "warm(a) room(a)\npress(a)\nlit(a) warm(a) room(a)\n");
  ASSERT_EQ(induced.outcomes.size(), 1u);
  EXPECT_EQ(induced.outcomes[0].changes.size(), 2u);
  EXPECT_DOUBLE_EQ(induced.outcomes[0].probability, 1);
}

TEST(InduceOutcomes, ConjoinsTwoThatExplainEachOthersExperiences) {
  const Induced induced = InduceFrom(
      "lit(a) room(a)\npress(a)\nlit(a) warm(a) room(a)\n"
      "warm(a) room(a)\npress(a)\nlit(a) warm(a) room(a)\n");
  ASSERT_EQ(induced.outcomes.size(), 1u);
  EXPECT_EQ(induced.outcomes[0].changes.size(), 2u);
}

TEST(InduceOutcomes, ChangesOfObjectsWithoutAVariableAreNoise) {
  const Induced induced = InduceFrom(
      std::string(kLights) + "room(a) room(b)\npress(a)\nroom(a) lit(b)\n");
  ASSERT_EQ(induced.outcomes.size(), 1u);
  EXPECT_DOUBLE_EQ(induced.noise, 0.5);
}

TEST(InduceOutcomes, LeavesToNoiseWhatCostsMoreThanItExplains) {
  LearnerOptions options;
  options.p_min = 0.05;
  options.alpha = 10;
  const Induced induced =
      InduceFrom(std::string(kStays) + kStays + kLights, options);
  ASSERT_EQ(induced.outcomes.size(), 1u);
  EXPECT_TRUE(induced.outcomes[0].changes.empty());
}

}  // namespace
}  // namespace cell::rules
