#include "services/cell/learning/rule_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "common/relational/domain.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

constexpr char kCompared[] = R"yaml(
types: {part: object, hole: object}
constants: {a: part, b: part, h: hole}
predicates:
  Clear: {arguments: [part]}
  In: {arguments: [part, hole]}
actions:
  Insert:
    arguments: {X: part, Y: hole}
    rules:
      - context: [Clear(X), "not In(_, Y)"]
        outcomes:
          - probability: 0.9
            effects:
              - "In(X, Y)"
              - {each: {P: part}, where: [], then: [not Clear(P)]}
        noise: 0.1
goals: {done: ["In(a, h)"]}
)yaml";

class RuleComparisonTest : public testing::Test {
 protected:
  static std::shared_ptr<const RuleSet> RulesWith(const std::string& what,
                                                  const std::string& instead) {
    std::string text = kCompared;
    if (!what.empty()) text.replace(text.find(what), what.size(), instead);
    return RuleSet::FromDomain(
        Domain::FromConfig(Config::Parse(text, "d.yaml"), PartTable()));
  }
  /// By which the reference differs from rules with a change.
  ActionComparison CompareWith(const std::string& what,
                               const std::string& instead) const {
    RuleComparison comparison(reference_, RulesWith(what, instead),
                              Agent::kPerson);
    for (const State& state : states_) comparison.Add(state);
    return comparison.actions().at("Insert");
  }
  State StateOf(const std::vector<std::string>& atoms) const {
    const Vocabulary& v = reference_->vocabulary();
    State state(v.num_atoms());
    for (int i = 0; i < v.num_atoms(); ++i) {
      if (std::ranges::count(atoms, v.AtomName(i)) > 0) {
        state.Set(i, Truth::kTrue);
      }
    }
    return state;
  }

  std::shared_ptr<const RuleSet> reference_ = RulesWith("", "");
  std::vector<State> states_ = {StateOf({"Clear(a)"})};
};

TEST_F(RuleComparisonTest, TheSameRulesDoNotDiffer) {
  const ActionComparison insert = CompareWith("", "");
  EXPECT_EQ(insert.num_both, 1);
  EXPECT_EQ(insert.num_same, 1);
  EXPECT_THAT(insert.differences, IsEmpty());
}

TEST_F(RuleComparisonTest, NamesTheConditionThatIsMissingOrTooMuch) {
  const ActionComparison lax = CompareWith("Clear(X), ", "");
  EXPECT_EQ(lax.num_learned_only, 1);  // b
  EXPECT_THAT(lax.differences,
              ElementsAre(Pair("reference: needs Clear(X)", 1)));
  const ActionComparison strict =
      CompareWith("Clear(X), ", "Clear(X), Clear(b), ");
  EXPECT_EQ(strict.num_reference_only, 1);
  EXPECT_THAT(strict.differences,
              ElementsAre(Pair("learned: needs Clear(b)", 1)));
}

TEST_F(RuleComparisonTest, NamesTheEffectThatIsMissingOrTooMuch) {
  states_ = {StateOf({"Clear(a)", "Clear(b)"})};
  const ActionComparison insert = CompareWith("each: {P: part}, where: []",
                                              "each: {P: part}, where: "
                                              "[\"In(P, h)\"]");
  EXPECT_EQ(insert.num_both, 2);
  EXPECT_EQ(insert.num_same, 0);
  EXPECT_THAT(insert.differences,
              ElementsAre(Pair("success lacks not Clear(X)", 2),
                          Pair("success lacks not Clear(part)", 2)));
}

TEST_F(RuleComparisonTest, StatesAreAllThatActionsLeadTo) {
  const std::vector<State> starts = {StateOf({"Clear(a)", "Clear(b)"})};
  const auto states = StatesFrom(starts, *reference_, Agent::kPerson, 100);
  EXPECT_THAT(states, ElementsAre(starts[0], StateOf({"In(a, h)"}),
                                  StateOf({"In(b, h)"})));
  EXPECT_THAT(StatesFrom(starts, *reference_, Agent::kPerson, 2), SizeIs(2));
}

}  // namespace
}  // namespace cell
