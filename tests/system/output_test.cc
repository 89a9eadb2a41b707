// What the command line leaves behind: nothing is overwritten, names belong to
// one process, what cannot be written is told.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "common/bus/event_log.h"
#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class Output : public RunCell {
 protected:
  void Put(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name) << text;
  }
  /// The command fails, names `file` and leaves it as it is.
  void ExpectKept(const std::string& command, const std::string& file) const {
    const std::string before = TextOf(dir_ / file);
    const ShellResult result = Cell(command);
    EXPECT_EQ(result.code, 1) << command << "\n" << result.output;
    EXPECT_THAT(result.output, HasSubstr(file + ": ")) << command;
    EXPECT_EQ(TextOf(dir_ / file), before) << command;
  }
  std::set<std::string> NamesIn(const fs::path& folder) const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(dir_ / folder)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
};

constexpr char kRow[] = R"({"group":"x","key":"x/900","seed":900})";

TEST_F(Output, RowsThatAreThereAreKeptUnlessTheyAreResumed) {
  Put("rows", std::string(kRow) + "\n");
  const std::string eval = "eval watch --runs 1 --seed 900 --rows rows";
  ExpectKept(eval, "rows");
  EXPECT_THAT(Cell(eval).output,
              AllOf(HasSubstr("--resume"), HasSubstr("another --rows")));
  // The default name, too.
  fs::create_directories(dir_ / "runs");
  Put("runs/eval-watch-seed900.jsonl", std::string(kRow) + "\n");
  ExpectKept("eval watch --runs 1 --seed 900", "runs/eval-watch-seed900.jsonl");
}

TEST_F(Output, WhatHoldsNoRowsIsNotResumed) {
  Put("rows", std::string(kRow) + "\nmy notes\n" + kRow + "\n");
  const std::string eval = "eval watch --runs 1 --seed 900 --resume --rows ";
  ExpectKept(eval + "rows", "rows");
  EXPECT_THAT(Cell(eval + "rows").output, HasSubstr("line 2"));
  Put("notes", "my notes");
  ExpectKept(eval + "notes", "notes");
}

TEST_F(Output, ARowFileBelongsToOneEvaluationAtATime) {
  Put("rows", "");
  const ShellResult run =
      Shell("cd " + dir_.string() + " && flock rows " + kCell +
            " eval watch --runs 1 --rows rows --resume");
  EXPECT_EQ(run.code, 1) << run.output;
  EXPECT_THAT(run.output, HasSubstr("rows: another evaluation writes to it"));
}

TEST_F(Output, MeasuresThatAreThereAreKept) {
  Put("m.json", "[]\n");
  const std::string eval = "eval watch --runs 1 --rows rows --json m.json";
  ExpectKept(eval, "m.json");
  // Another evaluation's are no earlier ones of this.
  ExpectKept(eval + " --resume", "m.json");
  EXPECT_FALSE(fs::exists(dir_ / "rows")) << "asked before it begins";
}

TEST_F(Output, NothingThatIsThereIsOverwritten) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  Put("mine", "hours of work\n");
  ExpectKept("view a --out mine", "mine");
  ExpectKept("view a --camera 1 --out mine", "mine");
  ExpectKept("library export mine --database a", "mine");
  ExpectKept("log repair a --out mine", "mine");
  ExpectKept("log convert a --out mine", "mine");
  ExpectKept("sim --seed 3 --out a", "a");
  fs::create_directories(dir_ / "types");
  Put("types/tick_t.lcm", "mine\n");
  ExpectKept("types --out types", "types/tick_t.lcm");
  EXPECT_EQ(NamesIn(""), (std::set<std::string>{"a", "mine", "types"}))
      << "and no drafts stay";
}

TEST_F(Output, RunsThatBeginAtOnceHaveFoldersOfTheirOwn) {
  std::string all;
  constexpr size_t kNum = 24;
  for (size_t i = 0; i < kNum; ++i) {
    all += kCell + " prepare --state-dir . >> said || echo failed & ";
  }
  const ShellResult run = Shell("cd " + dir_.string() + "; " + all + "wait");
  EXPECT_EQ(run.output, "");
  std::istringstream lines(TextOf(dir_ / "said"));
  std::set<std::string> told;
  for (std::string line; std::getline(lines, line);) told.insert(line);
  EXPECT_EQ(told.size(), kNum);
  const std::set<std::string> names = NamesIn("runs");
  EXPECT_EQ(names.size(), kNum + 1);
  for (const std::string& name : names) {
    EXPECT_TRUE(fs::exists(dir_ / "runs" / name / "run.yaml")) << name;
  }
}

TEST_F(Output, OfRunsThatAskForOneFolderOneHasIt) {
  std::string all;
  for (int i = 0; i < 6; ++i) {
    all += kCell +
           " sim --seed 3 --demonstration two_pegs --out a && echo "
           "good & ";
  }
  const ShellResult run = Shell("cd " + dir_.string() + "; " + all + "wait");
  size_t num_good = 0;
  for (size_t at = 0; (at = run.output.find("good\n", at)) < std::string::npos;
       ++at) {
    ++num_good;
  }
  EXPECT_EQ(num_good, 1u) << run.output;
  EXPECT_EQ(Cell("log check a").code, 0);
}

TEST_F(Output, AChannelsNameDoesNothingToTheTerminal) {
  {
    EventLogWriter writer(dir_ / "evil");
    writer.Write(0, "A\x1b[2J\nwhole\n0 findings", Bytes(40, 1));
    writer.Write(1, "TRACKS\x1b", Bytes(40, 2));
  }
  Put("e\x1b[2Jvil", "no log");
  for (const char* command :
       {"log check evil", "log check e?*vil", "log convert evil --out x",
        "log repair evil --out y", "view '\x1b[2J'"}) {
    const std::string output = Cell(command).output;
    EXPECT_EQ(output.find('\x1b'), std::string::npos) << command;
    EXPECT_EQ(output.find("\n0 findings\n"), std::string::npos) << command;
  }
}

TEST_F(Output, WhatCannotBePrintedIsAFailure) {
  for (const char* command :
       {"--help", "sim --help", "types --out t", "doctor"}) {
    const ShellResult run = Shell("(cd " + dir_.string() + " && " + kCell +
                                  " " + command + " 2>&1 >/dev/full)");
    EXPECT_EQ(run.code, 1) << command;
    EXPECT_THAT(run.output, HasSubstr("No space left on device")) << command;
  }
}

}  // namespace
}  // namespace cell
