#include "services/robot_arm/yield_policy.h"

#include <gtest/gtest.h>

namespace cell {

using namespace robot_arm;
namespace {

using Advice = YieldPolicy::Advice;

constexpr double kTick = 0.008;  // [s]

/// Ticks until the advice comes; -1 after a minute.
int TicksUntil(Advice advice, bool is_blocked, YieldPolicy& right) {
  for (int i = 0; i < 7500; ++i) {
    if (right.Step(is_blocked, kTick) == advice) return i;
  }
  return -1;
}

TEST(YieldPolicy, AnArmThatIsNotBlockedGoes) {
  YieldPolicy right(false);
  EXPECT_EQ(TicksUntil(Advice::kWait, false, right), -1);
}

TEST(YieldPolicy, OneOfTwoGoesOnFirst) {
  YieldPolicy first(true), second(false);
  EXPECT_EQ(first.Step(true, kTick), Advice::kWait);
  EXPECT_EQ(second.Step(true, kTick), Advice::kWait);
  EXPECT_LT(TicksUntil(Advice::kGo, false, first),
            TicksUntil(Advice::kGo, false, second) / 4);
}

TEST(YieldPolicy, AnArmBlockedForLongGoesAroundThenGivesUp) {
  YieldPolicy right(true);
  const int around = TicksUntil(Advice::kGoAround, true, right);
  EXPECT_GT(around, 0);
  EXPECT_GT(TicksUntil(Advice::kGiveUp, true, right), around);
}

TEST(YieldPolicy, OneOfTwoGivesUpSooner) {
  YieldPolicy first(true), second(false);
  EXPECT_LT(TicksUntil(Advice::kGiveUp, true, second),
            TicksUntil(Advice::kGiveUp, true, first) / 3);
}

TEST(YieldPolicy, AnArmThatHasGoneFreelyForgetsItsWaiting) {
  YieldPolicy right(true);
  const int first = TicksUntil(Advice::kGoAround, true, right);
  for (int i = 0; i < 250; ++i) right.Step(false, kTick);
  EXPECT_EQ(TicksUntil(Advice::kGoAround, true, right), first);
}

}  // namespace
}  // namespace cell
