#include "common/experiences/task_experience.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

using testing::HasSubstr;

class TaskExperienceTest : public testing::Test {
 protected:
  const Vocabulary& vocabulary() const { return task_.domain->vocabulary(); }

  /// Of an action that the task does not have; some atoms are unknown.
  TaskExperience Random() {
    const auto actions = task_.domain->GroundActions(Agent::kPerson);
    TaskExperience experience{
        "Action7", actions[random_() % actions.size()].arguments,
        random_() % 2 == 0 ? Agent::kPerson : Agent::kRobot,
        task_.RandomState(0.3, random_), task_.RandomState(0.3, random_)};
    for (State* state : {&experience.before, &experience.after}) {
      const auto num_atoms = static_cast<uint64_t>(state->num_atoms());
      state->Set(static_cast<int>(random_() % num_atoms), Truth::kUnknown);
    }
    return experience;
  }

  std::string WhyNot(const experience_t& message) const {
    return FromMessage(message, vocabulary()).reason();
  }

  const CranfieldRules task_;
  std::mt19937_64 random_{5};
};

TEST_F(TaskExperienceTest, IsTheSameAfterItsMessage) {
  for (int i = 0; i < 40; ++i) {
    const TaskExperience experience = Random();
    const auto read =
        FromMessage(ToMessage(experience, vocabulary()), vocabulary());
    ASSERT_TRUE(read) << read.reason();
    EXPECT_EQ(*read, experience);
  }
}

TEST_F(TaskExperienceTest, MayHaveChangedNothing) {
  TaskExperience experience = Random();
  experience.after = experience.before;
  EXPECT_EQ(WhyNot(ToMessage(experience, vocabulary())), "");
}

TEST_F(TaskExperienceTest, ANameThatIsNoneIsRefused) {
  experience_t message = ToMessage(Random(), vocabulary());
  for (const std::string& name :
       {std::string(), std::string("1st"), std::string("Put it"),
        std::string(TaskExperience::kMaxName + 1, 'a')}) {
    message.action = name;
    EXPECT_THAT(WhyNot(message), HasSubstr("action: should be a letter"));
  }
}

TEST_F(TaskExperienceTest, AnUnknownAgentIsRefused) {
  experience_t message = ToMessage(Random(), vocabulary());
  message.agent = "dog";
  EXPECT_EQ(WhyNot(message), "agent: should be person or robot, not 'dog'");
}

TEST_F(TaskExperienceTest, AnUnknownObjectIsRefusedWithTheNearestName) {
  experience_t message = ToMessage(Random(), vocabulary());
  message.arguments = {"heat"};
  EXPECT_THAT(WhyNot(message),
              HasSubstr("arguments: the task has no object 'heat'; did you "
                        "mean 'head'?"));
  message.arguments.assign(TaskExperience::kMaxObjects + 1, "head");
  EXPECT_THAT(WhyNot(message), HasSubstr("arguments: 17 are too many"));
}

class TaskExperienceAtoms : public TaskExperienceTest {
 protected:
  std::string WhyNotBefore(const literal_t& literal) {
    experience_t message = ToMessage(Random(), vocabulary());
    message.before = {literal};
    return WhyNot(message);
  }
  std::string WhyNotAfter(const std::vector<literal_t>& literals) {
    experience_t message = ToMessage(Random(), vocabulary());
    message.after = literals;
    return WhyNot(message);
  }
  static literal_t Clear(const std::string& part) {
    literal_t literal{};
    literal.predicate = "Clear";
    literal.arguments = {part};
    literal.num_arguments = 1;
    literal.value = literal_t::TRUE_;
    return literal;
  }
};

TEST_F(TaskExperienceAtoms, AreReadAsTrueUnknownAndElseFalse) {
  experience_t message = ToMessage(Random(), vocabulary());
  message.before = {Clear("head"), Clear("shaft")};
  message.before[1].value = literal_t::UNKNOWN;
  const auto read = FromMessage(message, vocabulary());
  ASSERT_TRUE(read) << read.reason();
  State expected(vocabulary().num_atoms());
  expected.Set(task_.Atom("Clear(head)"), Truth::kTrue);
  expected.Set(task_.Atom("Clear(shaft)"), Truth::kUnknown);
  EXPECT_EQ(read->before, expected);
}

TEST_F(TaskExperienceAtoms, OfAnotherVocabularyAreRefused) {
  literal_t literal = Clear("head");
  literal.predicate = "Cleer";
  EXPECT_THAT(WhyNotBefore(literal),
              HasSubstr("before[0]: the task has no predicate 'Cleer'; did you "
                        "mean 'Clear'?"));
  EXPECT_THAT(WhyNotBefore(Clear("nobody")),
              HasSubstr("before[0]: the task has no object 'nobody'"));
  literal = Clear("head");
  literal.predicate = "SeparatorPlaced";
  EXPECT_EQ(WhyNotBefore(literal),
            "before[0]: SeparatorPlaced(head) should be of separator");
}

TEST_F(TaskExperienceAtoms, OfAWrongNumberOfObjectsAreRefused) {
  literal_t literal = Clear("head");
  literal.arguments.push_back("shaft");
  EXPECT_EQ(WhyNotAfter({Clear("shaft"), literal}),
            "after[1]: Clear takes 1 objects, not 2");
}

TEST_F(TaskExperienceAtoms, ThatAreThereTwiceAreRefused) {
  EXPECT_EQ(WhyNotAfter({Clear("head"), Clear("shaft"), Clear("head")}),
            "after[2]: Clear(head) is there twice");
}

TEST_F(TaskExperienceAtoms, ThatAreFalseOrOfNoValueAreRefused) {
  for (const int value : {int{literal_t::FALSE_}, 3, -1}) {
    literal_t literal = Clear("head");
    literal.value = static_cast<int8_t>(value);
    EXPECT_THAT(WhyNotBefore(literal),
                HasSubstr("before[0]: Clear(head) has the value " +
                          std::to_string(value)));
  }
}

}  // namespace
}  // namespace cell
