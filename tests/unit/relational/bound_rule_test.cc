#include "common/relational/bound_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "common/relational/ground_action.h"
#include "tests/unit/bench_domain.h"

namespace cell {
namespace {

// References, quantified effects, `_`, and literals of types.
constexpr char kBoxes[] = R"yaml(
types: {box: object, chest: box, place: object}
constants: {box_1: box, box_2: box, chest_1: chest, shelf: place, floor: place,
            door: place}
static_facts:
  near: {arguments: [place, place], facts: [[shelf, floor], [floor, door]]}
predicates:
  At: {arguments: [box, place]}
  Open: {arguments: [box]}
actions:
  Move:
    arguments: {X: box, Y: place}
    rules:
      - references: {Z: {type: place, such_that: ["At(X, Z)"]}}
        context: ["near(Z, Y)", not Open(X), "not At(_, Y)"]
        outcomes:
          - {probability: 0.75, effects: ["At(X, Y)", "not At(X, Z)"]}
          - probability: 0.125
            effects:
              - {each: {U: box}, where: ["At(U, Z)"], then: [Open(U)]}
        noise: 0.125
  Shake:
    arguments: {X: box}
    rules:
      - context: [chest(X), "At(X, _)", not Open(_)]
        outcomes:
          - probability: 0.5
            effects:
              - {each: {U: box, V: place}, where: ["At(U, V)", box(U)],
                 then: ["not At(U, V)", Open(U)]}
              - {each: {U: chest}, where: [], then: [not Open(U)]}
          - {probability: 0.25, effects: [Open(X), "not At(X, shelf)"]}
        noise: 0.25
      - context: [Open(_)]
        outcomes: [{probability: 1, effects: [not Open(X)]}]
        noise: 0
goals:
  done: [Open(box_1)]
)yaml";

State RandomState(int num_atoms, std::mt19937_64& random) {
  State state(num_atoms);
  const double unknown = random() % 2 == 0 ? 0 : 0.2;
  std::discrete_distribution<int> truth({0.8 - unknown, 0.2, unknown});
  for (int atom = 0; atom < num_atoms; ++atom) {
    state.Set(atom, static_cast<Truth>(truth(random)));
  }
  return state;
}

TEST(BoundRule, CoversAndDoesWhatItsRuleDoes) {
  const BenchDomain bench(kBoxes);
  const RuleSet& rules = *bench.rules;
  const Vocabulary& vocabulary = rules.vocabulary();
  std::mt19937_64 random(1);
  int num_covered = 0, num_not_covered = 0;
  for (int i = 0; i < 500; ++i) {
    const State state = RandomState(vocabulary.num_atoms(), random);
    for (const GroundAction& ground : rules.GroundActions(Agent::kPerson)) {
      const Action& action = rules.ActionOf(ground);
      const auto applicable = ApplicableRules(action, ground.arguments, state,
                                              vocabulary, Agent::kPerson);
      for (size_t r = 0; r < action.rules.size(); ++r) {
        const BoundRule bound(action.rules[r], ground.arguments, vocabulary);
        const auto covering = std::ranges::find(applicable, static_cast<int>(r),
                                                &ApplicableRule::rule);
        ASSERT_EQ(bound.MayCover(state), covering != applicable.end());
        ++(bound.MayCover(state) ? num_covered : num_not_covered);
        if (covering == applicable.end()) continue;
        ASSERT_TRUE(bound.is_possible());
        for (size_t o = 0; o < action.rules[r].outcomes.size(); ++o) {
          ASSERT_EQ(bound.After(o, state),
                    Apply(action.rules[r].outcomes[o], covering->binding, state,
                          vocabulary))
              << rules.Show(ground);
        }
      }
    }
  }
  EXPECT_GT(num_covered, 500);
  EXPECT_GT(num_not_covered, 500);
}

TEST(BoundRule, IsNotPossibleForObjectsOfAnotherType) {
  const BenchDomain bench(kBoxes);
  const Vocabulary& vocabulary = bench.rules->vocabulary();
  const Action& shake = bench.rules->actions()[1];
  const NdrRule& of_chests = shake.rules[0];
  EXPECT_FALSE(
      BoundRule(of_chests, {bench.Object("box_1")}, vocabulary).is_possible());
  EXPECT_TRUE(BoundRule(of_chests, {bench.Object("chest_1")}, vocabulary)
                  .is_possible());
}

}  // namespace
}  // namespace cell
