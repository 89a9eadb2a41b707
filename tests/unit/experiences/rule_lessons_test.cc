#include "common/experiences/rule_lessons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "common/experiences/experience_text.h"
#include "common/experiences/own_changes.h"
#include "common/experiences/rule_conversion.h"
#include "common/rules/rule_text.h"
#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

std::string TextOf(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What the shipped task has experienced, and the rules learned from it.
class ShippedRules : public testing::Test {
 protected:
  ShippedRules() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_ / "experiences")) {
      files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) {
      for (const auto& e :
           ReadExperiences(TextOf(file), file.string(), task_.world)) {
        experiences_.push_back(e);
      }
    }
    rules_ = LearnRules(experiences_, GoalPredicates(task_.domain->goals()),
                        task_.world);
  }

  /// What the goal needs is planned by the learned rules.
  PlanSearch LearnedSearch() const {
    const auto actions = WithLearnedRules(rules_, task_.world);
    EXPECT_TRUE(actions) << actions.reason();
    const auto set = std::make_shared<const RuleSet>(
        "learned", 1, task_.rules->shared_vocabulary(), *actions);
    return PlanSearch(
        {set, *task_.domain->FindGoal("assembled"), Agent::kPerson}, {});
  }

  /// All states that valid placements lead to from the start.
  std::vector<State> ReachableStates() const {
    std::vector<State> states = {task_.Start()};
    for (size_t i = 0; i < states.size(); ++i) {
      for (const GroundAction& action : task_.Placements(states[i])) {
        const State next = task_.Do(states[i], action);
        if (std::ranges::count(states, next) == 0) states.push_back(next);
      }
    }
    return states;
  }

  const fs::path folder_ = fs::path(CELL_SOURCE_DIR) / "deploy/tasks/cranfield";
  CranfieldRules task_;
  std::vector<rules::Experience> experiences_;
  rules::NdrRules rules_;
};

TEST_F(ShippedRules, AreLearnedAgainByteForByte) {
  EXPECT_EQ(rules::ToText(rules_), TextOf(folder_ / "rules.ndr"));
}

/// The frozen model: the first planned action is valid by the rules that the
/// task's author wrote.
TEST_F(ShippedRules, PlanAValidActionFromEveryReachableState) {
  PlanSearch search = LearnedSearch();
  int num_valid = 0;
  const std::vector<State> states = ReachableStates();
  ASSERT_GT(states.size(), 200U);
  std::map<std::string, std::string> invalid;
  for (const State& state : states) {
    const Plan plan = search.Find(state);
    const bool is_valid =
        plan.result == Plan::Result::kGoalReached ||
        (plan.result == Plan::Result::kFound &&
         !task_.RulesFor(plan.steps.at(0).action, state).empty());
    num_valid += is_valid;
    if (!is_valid && plan.result == Plan::Result::kFound) {
      invalid[task_.domain->Show(plan.steps[0].action)] = plan.reason;
    } else if (!is_valid) {
      invalid["no plan"] = plan.reason;
    }
  }
  EXPECT_GE(num_valid, 0.98 * static_cast<double>(states.size()))
      << states.size() << " states; " << testing::PrintToString(invalid);
}

TEST_F(ShippedRules, AreLearnedOfEveryActionOfAPerson) {
  const auto actions = WithLearnedRules(rules_, task_.world);
  ASSERT_TRUE(actions) << actions.reason();
  for (size_t i = 0; i < actions->size(); ++i) {
    const Action& action = (*actions)[i];
    if (!action.MayBeDoneBy(Agent::kPerson)) continue;
    EXPECT_FALSE(action.rules.empty()) << action.name;
    EXPECT_NE(action.rules, task_.domain->actions()[i].rules) << action.name;
  }
}

/// A part of which no experience says that it cannot be taken needs to be taken
/// all the same, since of other parts some do.
TEST_F(ShippedRules, NeedWhatWasSeenToChangeOfOtherPartsOnly) {
  const rules::World& world = *task_.world.world();
  const rules::NdrRules& rules = rules_;
  const auto clear = [&](const rules::WorldState& state, int object) {
    return rules::Holds(
        {*world.symbols().Find("Clear"), {{rules::Term::Kind::kVariable, 0}}},
        std::vector<int>{object}, state, world);
  };
  int num_rules = 0;
  for (const rules::Rule& rule : rules.rules) {
    if (world.symbols()[rule.action].name != "ScrewHead") continue;
    ++num_rules;
    EXPECT_THAT(rules::ToText(rule, *rules.symbols), HasSubstr(" Clear(X)"));
  }
  EXPECT_GT(num_rules, 0);
  for (const rules::Experience& e : experiences_) {
    if (world.symbols()[e.act.action].name != "ScrewHead") continue;
    ASSERT_TRUE(clear(e.before, e.act.arguments[0]));
    ASSERT_TRUE(clear(e.after, e.act.arguments[0]));
  }
}

/// Learns from placements that are valid by the rules, in random orders.
TEST(RuleLessons, WhatHeldBeforeEachSuccessBecomesACondition) {
  const CranfieldRules task;
  std::mt19937_64 random(5);
  std::vector<rules::Experience> experiences;
  for (int i = 0; i < 20; ++i) {
    State state = task.Start();
    for (const GroundAction& action : task.RandomOrder(random)) {
      const State after = task.Do(state, action);
      experiences.push_back(task.world.ToExperience(state, action, after));
      state = after;
    }
  }
  const rules::NdrRules rules =
      LearnRules(experiences, GoalPredicates(task.domain->goals()), task.world);
  const auto text_of = [&](const std::string& name) -> std::string {
    for (const rules::Rule& rule : rules.rules) {
      if ((*rules.symbols)[rule.action].name == name) {
        return rules::ToText(rule, *rules.symbols);
      }
    }
    return "";
  };
  const std::string separator = text_of("PlaceSeparator");
  EXPECT_THAT(separator, HasSubstr("PegInHole(_, base.square_1)"));
  EXPECT_THAT(separator, HasSubstr("PegInHole(_, base.square_2)"));
  EXPECT_THAT(separator, Not(HasSubstr("base.round")));
  EXPECT_THAT(separator, HasSubstr(": SeparatorPlaced(X)\n"));
  const std::string peg = text_of("PlaceRoundPeg");
  EXPECT_THAT(peg, HasSubstr("fits(X, Y)"));
  EXPECT_THAT(peg, HasSubstr("Free(Y)"));
  EXPECT_THAT(text_of("PlaceFacePlate"), HasSubstr("HeadScrewed(_)"));
  // Nobody has shown it; it undoes what was shown.
  EXPECT_THAT(text_of("RemoveHead"), HasSubstr("not HeadScrewed(X)\n"));
}

TEST(RuleLessons, ChangesOfOtherObjectsAreLeftOut) {
  const CranfieldRules task;
  const auto action = task.Ground("PlaceSeparator", {"separator"});
  const State before = task.With(task.Start(), {"Horizontal(shaft)"});
  const State after = task.With(
      task.With(before, {"SeparatorPlaced(separator)"}),
      {"Free(base.shaft)", "Horizontal(shaft)", "Clear(head)"}, Truth::kFalse);
  const State own = task.With(before, {"SeparatorPlaced(separator)"});
  EXPECT_EQ(
      OwnChanges(task.world.ToExperience(before, action, after), task.world),
      task.world.ToExperience(before, action, own));
}

}  // namespace
}  // namespace cell
