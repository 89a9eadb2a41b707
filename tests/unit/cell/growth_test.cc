#include "services/cell/evaluations/growth.h"

#include <gmock/gmock.h>

namespace cell {

using namespace cli;
namespace {

TEST(TreeTask, NeedsAnActionForEachPartButTheFirst) {
  const rexd::RexdTask task = TreeTask(7);
  EXPECT_EQ(rules::GroundActs(*task.world, task.initial).size(), 6u);
  EXPECT_EQ(task.goal.size(), 7u);
  EXPECT_FALSE(task.IsGoal(task.initial));
  EXPECT_GT(PlanTree(7, 10'000), 6);
  EXPECT_EQ(PlanTree(20, 50), 50) << "the budget ends the search";
}

TEST(GrowthSeries, EndsAfterASizeThatTookTooLong) {
  double time = 0;
  const GrowthSeries series = MeasureGrowth(
      {"waiting", "objects", "size", {}}, {1, 2, 3, 4, 5}, 2.5,
      [&] { return time; },
      [&](int size) {
        time += size;
        return 10.0 * size;
      });
  ASSERT_EQ(series.points.size(), 3u);
  EXPECT_EQ(series.points.back().seconds, 3);
  EXPECT_EQ(series.points.back().result, 30);
  EXPECT_THAT(GrowthCsv({series}),
              testing::HasSubstr("waiting,objects,2,2,size,20\n"));
}

}  // namespace
}  // namespace cell
