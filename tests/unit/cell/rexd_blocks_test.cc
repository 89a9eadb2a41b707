#include "services/cell/evaluations/rexd_blocks.h"

#include <gmock/gmock.h>

#include "common/rexd/teacher.h"
#include "services/cell/commands/eval_rexd_options.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Two blocks of two episodes: the numbers of demonstrations.
json RowOf(const std::vector<int>& carried, const std::vector<int>& scratch) {
  json row;
  for (const auto& [knowledge, counts] :
       {std::pair(kCarriedOver, carried), std::pair(kFromScratch, scratch)}) {
    row[knowledge] = {{"actions", {9, 8, 7, 6}},
                      {"demonstrations", counts},
                      {"explorations", {0, 0, 0, 0}},
                      {"reached", {1, 1, 1, 1}}};
  }
  return row;
}

const BlockPlan kTwoBlocks{{"first", "second"}, {4, 5}, 2};

TEST(BlockStatements, AreTrueIfOneDemonstrationWasEnoughInEveryRun) {
  const RexdGroup group{
      1,
      {RowOf({5, 1, 1, 0}, {5, 1, 4, 0}), RowOf({6, 0, 0, 1}, {6, 0, 5, 0})}};
  const auto statements = CheckBlockStatements(kTwoBlocks, group);
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_TRUE(statements[0].is_true);
  EXPECT_THAT(statements[0].found, HasSubstr("1.00 instead of 4.50"));
  EXPECT_TRUE(statements[1].is_true);
  EXPECT_THAT(statements[1].found, HasSubstr("in 2 of 2 runs"));
}

TEST(BlockStatements, AreFalseIfMoreWereNeededOrNoFewer) {
  const RexdGroup group{
      1,
      {RowOf({5, 1, 2, 0}, {5, 1, 2, 0}), RowOf({6, 0, 0, 1}, {6, 0, 1, 0})}};
  const auto statements = CheckBlockStatements(kTwoBlocks, group);
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_FALSE(statements[0].is_true);
  EXPECT_FALSE(statements[1].is_true);
  EXPECT_THAT(statements[1].found, HasSubstr("in 1 of 2 runs"));
}

TEST(BlocksCsv, HasALineForEachEpisodeWithEitherKnowledge) {
  const RexdGroup group{0.5, {RowOf({5, 1, 2, 0}, {5, 1, 3, 0})}};
  const std::string csv = BlocksCsv(kTwoBlocks, {group});
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 4);
  EXPECT_THAT(csv, HasSubstr("0.5,carried over,second,3,7,0,2,0,0,0,1\n"));
  EXPECT_THAT(csv, HasSubstr("0.5,from scratch,second,3,7,0,3,0,0,0,1\n"));
}

TEST(ShippedTasks, HaveAWayToTheirGoals) {
  for (const auto& [name, distance] :
       {std::pair("placements", 8), std::pair("nine_steps", 9),
        std::pair("changed_tasks", 8), std::pair("dead_ends", 4)}) {
    EvalRexdOptions options;
    options.task_file = ShippedDeployment().task_dir / "learning" /
                        (std::string(name) + ".rules");
    RowIdentity identity;
    const rexd::RexdTask task = LoadRexdTask(options, &identity);
    rexd::PlanningTeacher teacher(task, 1, {}, 0);
    EXPECT_EQ(teacher.DistanceFrom(task.initial), distance) << name;
  }
}

// That a block's changes make sense: its goal is not reached at the start and
// can be reached, by more actions than without the changes.
TEST(ShippedBlocks, HaveAWayToTheirGoals) {
  EvalRexdOptions options;
  options.task_file =
      ShippedDeployment().task_dir / "learning/changed_tasks.rules";
  for (const char* name :
       {"lying_peg", "separator_first", "other_face_plate"}) {
    options.blocks.push_back(ShippedDeployment().task_dir / "learning" /
                             (std::string(name) + ".rules"));
  }
  RowIdentity identity;
  const rexd::RexdTask task = LoadRexdTask(options, &identity);
  rexd::PlanningTeacher teacher(task, 1, {}, 0);
  for (const rexd::RexdTask& block : LoadBlocks(options, &identity)) {
    EXPECT_NE(block.initial, task.initial);
    rexd::PlanningTeacher of_block(block, 1, {}, 0);
    EXPECT_GE(of_block.DistanceFrom(block.initial).value_or(0),
              teacher.DistanceFrom(task.initial).value());
  }
}

TEST(ShippedBlocks, OneThatIsNotThereIsNamed) {
  EvalRexdOptions options;
  options.deploy_dir = ShippedDeployment().task_dir.parent_path().parent_path();
  options.blocks = {"lying_pegs"};
  RowIdentity identity;
  try {
    LoadBlocks(options, &identity);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'lying_pegs' nor"));
  }
}

}  // namespace
}  // namespace cell
