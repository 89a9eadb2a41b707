#include "common/experiences/experience_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/rules/rule_error.h"
#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

using testing::HasSubstr;

TEST(ExperienceText, IsReadBackAsItWas) {
  const CranfieldRules task;
  std::mt19937_64 random(3);
  std::vector<rules::Experience> experiences;
  const auto actions = task.domain->GroundActions(Agent::kPerson);
  for (int i = 0; i < 40; ++i) {
    experiences.push_back(task.world.ToExperience(
        task.RandomState(0.3, random), actions[random() % actions.size()],
        task.RandomState(0.3, random)));
  }
  experiences.push_back(task.world.ToExperience(
      State(task.domain->vocabulary().num_atoms()), actions[0], task.Start()));
  const std::string text = ToText(experiences, task.world);
  EXPECT_EQ(ReadExperiences(text, "e", task.world), experiences);
}

TEST(ExperienceText, ErrorsNameTheLine) {
  const CranfieldRules task;
  const auto error_of = [&](const std::string& text) -> std::string {
    try {
      ReadExperiences(text, "e", task.world);
    } catch (const rules::RuleError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("Clear(head)\nScrewHead(head)\nClear(heat)\n"),
              HasSubstr("e:3: the task has no object 'heat'; did you mean"));
  EXPECT_THAT(
      error_of("Clear(head)\nPlaceSeparator(head)\nClear(head)\n"),
      HasSubstr("e:2: PlaceSeparator(head): 'head' is not a separator"));
  EXPECT_THAT(
      error_of("Clear(head)\nScrewHead(head)\nSeparatorPlaced(head)\n"),
      HasSubstr("e:3: SeparatorPlaced(head): 'head' is not a separator"));
}

}  // namespace
}  // namespace cell
