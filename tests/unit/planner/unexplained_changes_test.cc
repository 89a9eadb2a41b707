#include "services/planner/unexplained_changes.h"

#include <gmock/gmock.h>

#include "tests/unit/cranfield_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int64_t kSecond = 1'000'000;

class UnexplainedChangesTest : public testing::Test {
 protected:
  UnexplainedChangesTest()
      : unseen_(cranfield_.rules->shared_vocabulary(),
                cranfield_.domain->goals(), {.patience_us = 15 * kSecond}) {
    unseen_.Update({1, 0, before_});
  }
  State AfterFirstStep() const { return cranfield_.Do(before_, FirstStep()); }
  GroundAction FirstStep() const {
    return cranfield_.Search().Find(before_).steps.at(0).action;
  }
  DoneAction Action(int64_t pick_frame, int64_t place_frame, int64_t utime) {
    return {.index = 1,
            .utime = utime,
            .pick_key_frame = pick_frame,
            .place_key_frame = place_frame,
            .objects = FirstStep().arguments,
            .pick_utime = utime - 2 * kSecond};
  }

  Cranfield cranfield_;
  State before_ = cranfield_.Start();
  UnexplainedChanges unseen_;
};

TEST_F(UnexplainedChangesTest, ARecognisedActionAccountsForWhatItDid) {
  unseen_.Update({3, 5 * kSecond, AfterFirstStep()});
  unseen_.Update(Action(2, 4, 6 * kSecond));
  EXPECT_THAT(unseen_.TakeOverdue(100 * kSecond), IsEmpty());
}

TEST_F(UnexplainedChangesTest, WhatSettlesAfterwardsBelongsToTheAction) {
  unseen_.Update(Action(2, 4, 6 * kSecond));
  unseen_.Update({5, 7 * kSecond, AfterFirstStep()});
  EXPECT_THAT(unseen_.TakeOverdue(100 * kSecond), IsEmpty());
}

TEST_F(UnexplainedChangesTest, ReportsUnrecognisedChangesOnce) {
  unseen_.Update({30, 50 * kSecond, AfterFirstStep()});
  unseen_.Update(Action(2, 4, 6 * kSecond));  // another one
  EXPECT_THAT(unseen_.TakeOverdue(60 * kSecond), IsEmpty());
  EXPECT_THAT(unseen_.TakeOverdue(70 * kSecond),
              ElementsAre(HasSubstr("at 50.00 s")));
  EXPECT_THAT(unseen_.TakeOverdue(71 * kSecond), IsEmpty());
}

TEST_F(UnexplainedChangesTest, WhatIsNotKnownIsNoChange) {
  State dark = before_;
  for (int atom = 0; atom < dark.num_atoms(); ++atom) {
    dark.Set(atom, Truth::kUnknown);
  }
  unseen_.Update({2, kSecond, dark});
  unseen_.Update({3, 2 * kSecond, before_});
  EXPECT_THAT(unseen_.TakeOverdue(100 * kSecond), IsEmpty());
}

}  // namespace
}  // namespace cell
