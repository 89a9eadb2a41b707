// Mistakes in people's assemblies, from files to verdicts, as users run it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MistakesCommand : public RunCell {
 protected:
  void WriteAnnotations() {
    fs::create_directories(dir_ / "toys");
    for (const char* toy : {"t1", "t2", "t3"}) {
      Write(toy, 1,
            "1,2,attach,roof,frame,mistake,wrong order\n"
            "2,3,detach,roof,frame,correction,\n"
            "3,4,attach,seat,frame,correct,\n"
            "4,5,attach,frame,Roof,correct,\n");
      Write(toy, 2,
            "1,2,attach,seat,frame,correct,\n"
            "2,3,attach,roof,frame,correct,\n");
    }
  }

  void Write(const std::string& toy, int actor, const std::string& rows) {
    std::ofstream(FileOf(toy, actor)) << rows;
  }

  fs::path FileOf(const std::string& toy, int actor) const {
    return dir_ / "toys" / ("s_" + std::to_string(actor) + "-" + toy + "_.csv");
  }
};

TEST_F(MistakesCommand, AreCountedBesideControlsAndBadRowsAreNamed) {
  WriteAnnotations();
  Write("t1", 3, "1,2,position,seat,frame,correct,\n7\n");
  Write("t4", 1, "");
  const ShellResult run = Cell("eval mistakes toys --csv toys.csv");
  EXPECT_THAT(run.output, HasSubstr("majority class"));
  EXPECT_THAT(run.output, HasSubstr("precedence of pairs"));
  EXPECT_THAT(run.output, HasSubstr("macro F1 "));
  EXPECT_THAT(run.output, HasSubstr("s_3-t1_.csv:1: 'position' is no verb"));
  EXPECT_THAT(run.output, HasSubstr("s_3-t1_.csv:2: 1 column;"));
  EXPECT_THAT(run.output, HasSubstr("s_1-t4_.csv:1: holds no action"));
  EXPECT_THAT(run.output, HasSubstr("20 rows in 8 files, 1 skipped"));
  std::ifstream csv(dir_ / "toys.csv");
  std::string line;
  int num_lines = 0;
  while (std::getline(csv, line)) ++num_lines;
  EXPECT_EQ(num_lines, 4) << "a heading and three toys";
  EXPECT_EQ(run.output, Cell("eval mistakes toys").output);
}

TEST_F(MistakesCommand, AreExplainedLineByLineByRulesThatAreShown) {
  WriteAnnotations();
  const ShellResult run =
      Cell("monitor --annotations toys/s_1-t1_.csv --rules t1.rules");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("mistake (wrong order): its rule requires frame - "
                        "seat, which is not attached yet; the plan grew by 1"));
  EXPECT_THAT(run.output, HasSubstr("4 of 4 verdicts as annotated"));
  EXPECT_THAT(Cell("rules show t1.rules").output,
              HasSubstr("Preconditions: joined(frame, seat)"));
}

TEST_F(MistakesCommand, WithoutUsableInputSaySo) {
  EXPECT_THAT(Cell("eval mistakes nowhere").output,
              HasSubstr("nowhere: is no folder"));
  fs::create_directories(dir_ / "toys");
  EXPECT_THAT(Cell("eval mistakes toys").output,
              HasSubstr("holds no annotations"));
  Write("t1", 1, "1,2,attach,seat,frame,correct,\n");
  const ShellResult alone = Cell("eval mistakes toys");
  EXPECT_EQ(alone.code, 1);
  EXPECT_THAT(alone.output, HasSubstr("no toy has two sequences"));
  const ShellResult monitor = Cell("monitor --annotations toys/s_1-t1_.csv");
  EXPECT_EQ(monitor.code, 0) << monitor.output;
  EXPECT_THAT(monitor.output, HasSubstr("nothing is known of this toy"));
  for (const char* text : {"", "\x01\x02\xff\n\x7f", "1,2,seat,attach,a,,\n"}) {
    Write("t1", 1, text);
    const ShellResult none = Cell("monitor --annotations toys/s_1-t1_.csv");
    EXPECT_EQ(none.code, 1);
    EXPECT_THAT(none.output, HasSubstr("s_1-t1_.csv: holds no action"));
  }
}

}  // namespace
}  // namespace cell
