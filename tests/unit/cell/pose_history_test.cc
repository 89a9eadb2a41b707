#include "services/cell/scoring/pose_history.h"

#include <gtest/gtest.h>

namespace cell {

using namespace cli;
namespace {

void PutAt(int64_t utime, PoseHistory& pose_history) {
  truth_poses_t poses{};
  poses.header.utime = utime;
  pose_history.Put(poses);
}

TEST(PoseHistory, AreAlwaysFarEnoughApart) {
  for (const int64_t period : {8'000, 64'000, 150'000, 900'000}) {
    PoseHistory pose_history;
    for (int i = 0; i < 100; ++i) {
      PutAt(i * period, pose_history);
      if (i * period < PoseHistory::kApartUs) continue;
      ASSERT_TRUE(pose_history.has_both()) << period << " " << i;
      const int64_t apart = pose_history.last().header.utime -
                            pose_history.earlier().header.utime;
      EXPECT_GE(apart, PoseHistory::kApartUs);
      EXPECT_LT(apart, PoseHistory::kApartUs + period);
    }
  }
}

TEST(PoseHistory, StartAgainWhenTimesRunBackwards) {
  PoseHistory pose_history;
  EXPECT_TRUE(pose_history.is_empty());
  PutAt(0, pose_history);
  PutAt(500'000, pose_history);
  EXPECT_TRUE(pose_history.has_both());
  PutAt(100'000, pose_history);
  EXPECT_FALSE(pose_history.has_both());
  EXPECT_FALSE(pose_history.is_empty());
  PutAt(INT64_MIN, pose_history);
  EXPECT_FALSE(pose_history.has_both());
  PutAt(INT64_MAX, pose_history);
  EXPECT_TRUE(pose_history.has_both());
}

}  // namespace
}  // namespace cell
