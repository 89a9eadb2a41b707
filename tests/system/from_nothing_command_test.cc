// A cell that starts without actions, event chains and rules, and a person who
// shows it what it asks for.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FromNothingCommand : public RunCell {
 protected:
  /// A deployment whose taught episodes end after so many seconds.
  void EndAfter(const std::string& seconds) {
    fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
             fs::copy_options::recursive);
    const fs::path scripts =
        dir_ / "deploy" / "tasks" / "cranfield" / "demonstrators.yaml";
    std::string text = TextOf(scripts);
    const std::string duration = "max_duration_s: ";
    const size_t at = text.find(duration, text.find("  taught:"));
    ASSERT_LT(at, text.size());
    const size_t end = text.find(',', at);
    text.replace(at, end - at, duration + seconds);
    std::ofstream(scripts) << text;
  }
};

// One demonstration, and what the arms make of it.
TEST_F(FromNothingCommand, LearnsTheSameOverLcmInOneProcessAndOnReplay) {
  EndAfter("40");
  const std::string arguments =
      " --from-nothing --deploy deploy --demonstration taught+taught --seed 1";
  EXPECT_EQ(Hash("demo --out a" + arguments), Hash("sim --out b" + arguments));
  const ShellResult replay = Cell("replay b --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
  const ShellResult told = Cell("replay b");
  EXPECT_THAT(told.output, HasSubstr("QUESTION: please show me one of these"));
  EXPECT_THAT(told.output, HasSubstr("learned as Action1(round_peg_"));
  const size_t second = told.output.find("episode 2:");
  ASSERT_LT(second, told.output.size());
  EXPECT_THAT(told.output.substr(second), HasSubstr("recognised Action1("))
      << "the arm does what it was shown in the episode before";
}

TEST_F(FromNothingCommand, AnEvaluationKeepsEveryQuestion) {
  EndAfter("12");
  const ShellResult eval = Cell(
      "eval from_nothing --runs 1 --seed 5 --deploy deploy --rows rows "
      "--json measures");
  EXPECT_EQ(eval.code, 1) << "nobody can learn that in 12 s: " << eval.output;
  EXPECT_THAT(eval.output, HasSubstr("without a question in the third"));
  const std::string rows = TextOf(dir_ / "rows");
  EXPECT_THAT(rows, HasSubstr("please show me one of these"));
  const ShellResult again = Cell(
      "eval from_nothing --runs 1 --seed 5 --deploy deploy --rows rows "
      "--resume");
  EXPECT_THAT(again.output, HasSubstr("(1 of 1 runs)"));
  EXPECT_EQ(TextOf(dir_ / "rows"), rows) << "nothing was run again";
}

}  // namespace
}  // namespace cell
