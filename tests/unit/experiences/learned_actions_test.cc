// What is learned piece by piece, as a cell does it that learns while it runs,
// is what all experiences together teach.
#include "common/experiences/learned_actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_lessons.h"
#include "common/rules/rule_text.h"
#include "common/task/shipped_experiences.h"
#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

constexpr size_t kNumExperiences = 120;

class Piecemeal : public testing::Test {
 protected:
  /// Some of the shipped experiences in a random order, with random ids.
  std::map<int64_t, TaskExperience> Draw(std::mt19937_64& random) const {
    std::vector<TaskExperience> all =
        ReadShippedExperiences(task_.deployment, *task_.domain);
    std::ranges::shuffle(all, random);
    std::map<int64_t, TaskExperience> drawn;
    while (drawn.size() < kNumExperiences) {
      drawn.emplace(static_cast<int64_t>(random() % 100'000),
                    all.at(drawn.size()));
    }
    return drawn;
  }
  std::vector<int64_t> RandomOrder(
      const std::map<int64_t, TaskExperience>& experiences,
      std::mt19937_64& random) const {
    std::vector<int64_t> ids;
    for (const auto& [id, experience] : experiences) ids.push_back(id);
    std::ranges::shuffle(ids, random);
    return ids;
  }
  rules::Experience InWorld(const TaskExperience& e) const {
    const auto action = task_.domain->FindAction(e.action);
    return task_.world.ToExperience(e.before, {action.value(), e.objects},
                                    e.after);
  }
  LearnedActions NothingLearned(std::span<const Action> actions) const {
    return LearnedActions(actions, task_.domain->goals(),
                          task_.rules->shared_vocabulary());
  }
  std::vector<Action> WithoutRules() const {
    std::vector<Action> actions = task_.domain->actions();
    for (Action& action : actions) action.rules.clear();
    return actions;
  }

  CranfieldRules task_;
};

TEST_F(Piecemeal, RuleLessonsAreThoseOfAllExperiences) {
  std::mt19937_64 random(3);
  const auto goals = GoalPredicates(task_.domain->goals());
  for (const int num_for_others : {1, kManySuccesses}) {
    const auto experiences = Draw(random);
    RuleLessons lessons(std::make_shared<const RuleWorld>(task_.world), goals,
                        num_for_others);
    std::map<int64_t, rules::Experience> known;
    int num_steps = 0;
    for (const int64_t id : RandomOrder(experiences, random)) {
      known.emplace(id, InWorld(experiences.at(id)));
      lessons.Add(id, known.at(id));
      if (random() % 4 == 0) {  // some are forgotten again
        const auto gone = std::next(
            known.begin(), static_cast<int64_t>(random() % known.size()));
        lessons.Remove(gone->first);
        known.erase(gone);
      }
      const std::string text = rules::ToText(lessons.Learn());
      if (++num_steps % 8 != 0) continue;
      std::vector<rules::Experience> all;
      for (const auto& [i, experience] : known) all.push_back(experience);
      ASSERT_EQ(text, rules::ToText(
                          LearnRules(all, goals, task_.world, num_for_others)))
          << "after " << num_steps;
    }
    EXPECT_GT(known.size(), 50U);
  }
}

TEST_F(Piecemeal, AnActionMayBecomeKnownAfterItsExperiences) {
  std::mt19937_64 random(4);
  const std::vector<Action> actions = WithoutRules();
  const auto experiences = Draw(random);
  const size_t num_first = actions.size() / 2;
  LearnedActions piecemeal =
      NothingLearned(std::span(actions).first(num_first));
  LearnedActions at_once = NothingLearned(actions);
  for (const int64_t id : RandomOrder(experiences, random)) {
    EXPECT_TRUE(piecemeal.Add(id, experiences.at(id)));
  }
  for (const auto& [id, experience] : experiences) at_once.Add(id, experience);
  const auto first = piecemeal.Learn();
  ASSERT_TRUE(first) << first.reason();
  EXPECT_EQ(first->size(), num_first);
  piecemeal.SetActions(actions);
  const auto all = piecemeal.Learn();
  ASSERT_TRUE(all) << all.reason();
  EXPECT_EQ(*all, *at_once.Learn());
  const bool are_later_ones_learned = std::ranges::any_of(
      std::span(*all).subspan(num_first),
      [](const Action& action) { return !action.rules.empty(); });
  EXPECT_TRUE(are_later_ones_learned);
}

TEST_F(Piecemeal, EachRuleSaysFromHowManyExperiencesItWasLearned) {
  std::mt19937_64 random(5);
  LearnedActions learned = NothingLearned(WithoutRules());
  const auto experiences = Draw(random);
  for (const auto& [id, experience] : experiences) learned.Add(id, experience);
  EXPECT_FALSE(learned.Add(experiences.begin()->first, {}));
  const auto count = [&](const std::string& name) {
    int sum = 0;
    const std::vector<Action> actions = *learned.Learn();
    const auto it = std::ranges::find(actions, name, &Action::name);
    for (const NdrRule& rule : it->rules) sum += rule.num_experiences;
    return sum;
  };
  const std::string name = experiences.begin()->second.action;
  const auto num = std::ranges::count_if(experiences, [&](const auto& entry) {
    return entry.second.action == name;
  });
  EXPECT_GT(count(name), 0);
  EXPECT_LE(count(name), num);
  for (const auto& [id, experience] : experiences) {
    if (experience.action != name) continue;
    EXPECT_TRUE(learned.Remove(id));
  }
  EXPECT_FALSE(learned.Remove(experiences.begin()->first));
  EXPECT_EQ(count(name), 0);
  EXPECT_EQ(learned.experiences().size(),
            experiences.size() - static_cast<size_t>(num));
}

}  // namespace
}  // namespace cell
