// Which experiences a library takes.
#include "services/library/experience_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/actions/action_model_writer.h"
#include "services/library/memory_action_store.h"
#include "tests/unit/library/some_experiences.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;
namespace {

using testing::HasSubstr;

class ExperienceCheckTest : public testing::Test {
 protected:
  Refusal WhyNot(const experience_t& message) const {
    return check_.WhyNot(message, store_).value_or(Refusal{});
  }

  const ShippedTask task_;
  const ExperienceCheck check_{task_.domain.vocabulary()};
  MemoryActionStore store_{WriteActionModels(task_.actions, task_.domain)};
};

TEST_F(ExperienceCheckTest, TakesThoseOfActionsThatItDoesNotKnow) {
  EXPECT_FALSE(check_.WhyNot(ToMessage(Tried("Action1")), store_));
}

TEST_F(ExperienceCheckTest, TakesThoseThatContradictEachOther) {
  ExperienceRecord other = Tried("Action1");
  store_.Keep(other, 1);
  std::swap(other.before, other.after);
  EXPECT_FALSE(check_.WhyNot(ToMessage(other), store_));
}

TEST_F(ExperienceCheckTest, RefusesAnIdThatIsNotTheLibrarys) {
  experience_t message = ToMessage(Tried("Action1"));
  message.id = 4;
  EXPECT_THAT(WhyNot(message).reason, HasSubstr("it has the id 4"));
}

TEST_F(ExperienceCheckTest, RefusesAWrongNumberOfObjectsOfAKnownAction) {
  EXPECT_EQ(WhyNot(ToMessage(Tried("PlaceRoundPeg"))).reason,
            "arguments: PlaceRoundPeg takes 2 objects, not 1");
}

TEST_F(ExperienceCheckTest, RefusesWordsOfAnotherTask) {
  ExperienceRecord experience = Tried("Action1");
  experience.after = {"Frobnicated(shaft)"};
  EXPECT_THAT(WhyNot(ToMessage(experience)).reason,
              HasSubstr("after[0]: the task has no predicate 'Frobnicated'"));
}

TEST_F(ExperienceCheckTest, RefusesWhatIsTooLarge) {
  experience_t message = ToMessage(Tried("Action1"));
  message.before[0].predicate.assign(ExperienceRecord::kMaxBytes, 'p');
  EXPECT_EQ(WhyNot(message).kind, Refusal::Kind::kTooLarge);
  EXPECT_THAT(WhyNot(message).reason, HasSubstr("bytes are too many"));
}

TEST_F(ExperienceCheckTest, RefusesAllThatIsMoreThanTheLibraryTakes) {
  StoreEdit edit;
  edit.experiences.assign(
      static_cast<size_t>(ExperienceCheck::kMaxExperiences) - 1,
      Tried("Action1"));
  store_.Apply(edit, 1);
  EXPECT_FALSE(check_.WhyNot(ToMessage(Tried("Action1")), store_));
  store_.Keep(Tried("Action1"), 2);
  EXPECT_EQ(WhyNot(ToMessage(Tried("Action1"))).kind, Refusal::Kind::kTooLarge);
  EXPECT_THAT(WhyNot(ToMessage(Tried("Action1"))).reason,
              HasSubstr("the library is full"));
}

TEST_F(ExperienceCheckTest, NamesThePredicateOfALibraryOfAnotherTask) {
  EXPECT_EQ(check_.WhyOfAnotherTask(store_), std::nullopt);
  ExperienceRecord experience = Tried("Action1");
  store_.Keep(experience, 1);
  EXPECT_EQ(check_.WhyOfAnotherTask(store_), std::nullopt);
  experience.after = {"Cleer(shaft)"};
  store_.Keep(experience, 1);
  EXPECT_THAT(check_.WhyOfAnotherTask(store_).value(),
              HasSubstr("experience 2: the task has no predicate 'Cleer'; did "
                        "you mean 'Clear'?"));
}

TEST_F(ExperienceCheckTest, NamesAPredicateOfAnotherNumberOfObjects) {
  ExperienceRecord experience = Tried("Action1");
  experience.before = {"Clear(shaft, separator)"};
  store_.Keep(experience, 1);
  EXPECT_EQ(check_.WhyOfAnotherTask(store_),
            "experience 1: Clear takes 1 objects, not 2");
}

TEST_F(ExperienceCheckTest, AVariantsPartsAreOfTheTaskButNotOfThisCell) {
  ExperienceRecord experience = Tried("Action1");
  EXPECT_TRUE(check_.IsOfTask(experience));
  experience.objects = {"thin_peg_1"};
  store_.Keep(experience, 1);
  EXPECT_EQ(check_.WhyOfAnotherTask(store_), std::nullopt);
  EXPECT_FALSE(check_.IsOfTask(experience));
}

}  // namespace
}  // namespace cell
