#include "common/relational/undoing.h"

#include <gtest/gtest.h>

#include <string>

namespace cell {
namespace {

constexpr char kUndoing[] = R"yaml(
types: {part: object, hole: object}
constants: {bolt: part, hole: hole}
predicates:
  Clear: {arguments: [part]}
  Empty: {arguments: [hole]}
  In: {arguments: [part, hole]}
actions:
  Insert:
    arguments: {X: part, Y: hole}
    rules:
      - context: [Clear(X)]
        outcomes:
          - {probability: 0.7, effects: ["In(X, Y)", not Empty(Y)]}
          - {probability: 0.2, effects: [not Clear(X)]}
        noise: 0.1
      - context: [not Clear(X)]
        outcomes: [{probability: 0.5, effects: ["In(X, Y)"]}]
        noise: 0.5
  Remove:
    arguments: {X: part, Y: hole}
    rules:
      - context: ["In(X, Y)"]
        outcomes:
          - {probability: 0.3, effects: [Clear(X)]}
          - {probability: 0.7, effects: ["not In(X, Y)", Empty(Y)]}
        noise: 0
  Loosen:
    arguments: {X: part, Y: hole}
    rules:
      - context: ["In(X, Y)", Clear(X)]
        outcomes: [{probability: 1, effects: ["not In(X, Y)"]}]
        noise: 0
      - context: ["In(X, Y)", not Clear(X)]
        outcomes: [{probability: 1, effects: [Clear(X)]}]
        noise: 0
  Shake:
    arguments: {X: part}
    rules:
      - context: []
        outcomes:
          - probability: 1
            effects:
              - {each: {Y: hole}, where: ["In(X, Y)"], then: ["not In(X, Y)"]}
        noise: 0
  Nothing: {arguments: {X: part, Y: hole}}
goals: {done: ["In(bolt, hole)"]}
)yaml";

class Undoing : public testing::Test {
 protected:
  std::optional<int> UndoneBy(const std::string& name) const {
    const Action& action =
        domain_
            .actions()[static_cast<size_t>(domain_.FindAction(name).value())];
    return DeriveUndone(action, domain_.actions(), domain_.goals());
  }

  Domain domain_ =
      Domain::FromConfig(Config::Parse(kUndoing, "d.yaml"), PartTable());
};

TEST_F(Undoing, AnActionUndoesWhatItsSuccessTakesBack) {
  EXPECT_EQ(UndoneBy("Remove"), domain_.FindAction("Insert"));
}

// Insert() takes Empty(Y) away, which Remove() gives; no goal wants that.
TEST_F(Undoing, IsAboutWhatTheGoalsWant) {
  EXPECT_EQ(UndoneBy("Insert"), std::nullopt);
}

TEST_F(Undoing, EveryRuleOfTheActionMustTakeItBack) {
  EXPECT_EQ(UndoneBy("Loosen"), std::nullopt);
}

TEST_F(Undoing, OtherArgumentsAndUnknownActionsUndoNothing) {
  EXPECT_EQ(UndoneBy("Shake"), std::nullopt);
  EXPECT_EQ(UndoneBy("Nothing"), std::nullopt);
}

TEST_F(Undoing, OfTwoThatCouldBeMeantNoneIs) {
  Action twin = domain_.actions()[0];
  twin.name = "Push";
  domain_.Put(twin);
  EXPECT_EQ(UndoneBy("Remove"), std::nullopt);
}

}  // namespace
}  // namespace cell
