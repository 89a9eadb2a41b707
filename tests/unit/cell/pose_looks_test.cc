#include "services/cell/scoring/pose_looks.h"

#include <gtest/gtest.h>

namespace cell {

using namespace cli;
namespace {

void PutAt(int64_t utime, PoseLooks& looks) {
  truth_poses_t poses{};
  poses.header.utime = utime;
  looks.Put(poses);
}

TEST(PoseLooks, AreAlwaysFarEnoughApart) {
  for (const int64_t period : {8'000, 64'000, 150'000, 900'000}) {
    PoseLooks looks;
    for (int i = 0; i < 100; ++i) {
      PutAt(i * period, looks);
      if (i * period < PoseLooks::kApartUs) continue;
      ASSERT_TRUE(looks.has_both()) << period << " " << i;
      const int64_t apart =
          looks.last().header.utime - looks.earlier().header.utime;
      EXPECT_GE(apart, PoseLooks::kApartUs);
      EXPECT_LT(apart, PoseLooks::kApartUs + period);
    }
  }
}

TEST(PoseLooks, BeginAnewWhenTimesRunBackwards) {
  PoseLooks looks;
  EXPECT_TRUE(looks.is_empty());
  PutAt(0, looks);
  PutAt(500'000, looks);
  EXPECT_TRUE(looks.has_both());
  PutAt(100'000, looks);
  EXPECT_FALSE(looks.has_both());
  EXPECT_FALSE(looks.is_empty());
  PutAt(INT64_MIN, looks);
  EXPECT_FALSE(looks.has_both());
  PutAt(INT64_MAX, looks);
  EXPECT_TRUE(looks.has_both());
}

}  // namespace
}  // namespace cell
