// cell library, as its users run it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "services/library/open_store.h"
#include "services/library/sqlite_action_store.h"
#include "tests/system/run_cell.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LibraryCommand : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    fs::create_directories(dir_ / "a");
    Deployment deployment = ShippedDeployment();
    deployment.run_dir = dir_ / "a";
    OpenStore(deployment, {});  // as a run does at its start
  }
  void Replace(const fs::path& file, const std::string& from,
               const std::string& to) const {
    std::string text = TextOf(file);
    const size_t at = text.find(from);
    ASSERT_LT(at, text.size());
    std::ofstream(file) << text.replace(at, from.size(), to);
  }
};

TEST_F(LibraryCommand, EachPartShowsAnExample) {
  for (const char* part :
       {"", " list", " show", " export", " import", " changes", " rename",
        " remove", " merge", " take-back", " rollback"}) {
    const ShellResult help = Cell("library" + std::string(part) + " --help");
    EXPECT_EQ(help.code, 0) << part;
    EXPECT_THAT(help.output, HasSubstr("Example: cell library")) << part;
  }
}

TEST_F(LibraryCommand, ListsAndShowsWhatARunHas) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out run").code, 0);
  EXPECT_EQ(TextOf(dir_ / "run" / "library.json"),
            TextOf(dir_ / "a" / "library.json"));
  const ShellResult list = Cell("library list --database run");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(
      list.output,
      HasSubstr(
          "   1  PlaceRoundPeg(X: cylindrical_peg, Y: cylindrical_hole)"));
  EXPECT_THAT(list.output, HasSubstr("  15  PutDown(X: movable, A: arm)"));
  const ShellResult show = Cell("library show 1 --database run/library.db");
  EXPECT_THAT(show.output, HasSubstr("moved: X"));
  EXPECT_THAT(show.output, HasSubstr("insertion"));
  const ShellResult none = Cell("library show 99 --database a");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.output, HasSubstr("no action has the id 99"));
}

TEST_F(LibraryCommand, ExportedIsImportedWithTheSameIds) {
  EXPECT_EQ(Cell("library export all.json --database a").code, 0);
  EXPECT_EQ(TextOf(dir_ / "all.json"), TextOf(dir_ / "a" / "library.json"));
  const ShellResult run = Cell("library import all.json --database new.db");
  EXPECT_THAT(run.output, HasSubstr("15 actions imported, 0 already present"));
  EXPECT_THAT(Cell("library import all.json --database new.db").output,
              HasSubstr("0 actions imported, 15 already present"));
  EXPECT_EQ(Cell("library export new.json --database new.db").code, 0);
  EXPECT_EQ(TextOf(dir_ / "new.json"), TextOf(dir_ / "all.json"));
}

TEST_F(LibraryCommand, WhatCannotBeKeptIsNamedAndNothingIsImported) {
  Replace(dir_ / "a" / "library.json", "\"ScrewHead\"", "\"Screw head\"");
  const ShellResult name =
      Cell("library import a/library.json --database new.db");
  EXPECT_EQ(name.code, 1);
  EXPECT_THAT(
      name.output,
      HasSubstr("a/library.json:actions[4]: its name should be a letter"));
  EXPECT_FALSE(fs::exists(dir_ / "new.db"));
  Replace(dir_ / "a" / "library.json", "\"undoes\"", "\"undone\"");
  EXPECT_THAT(Cell("library import a/library.json --database new.db").output,
              HasSubstr("a/library.json:actions[0].undone: not known"));
}

TEST_F(LibraryCommand, AnotherActionOfTheSameNameIsRefused) {
  Replace(dir_ / "a" / "library.json", "not Free(Y)", "Free(Y)");
  const ShellResult run = Cell("library import a/library.json --database a");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("actions[0]: 'PlaceRoundPeg' already "
                                    "exists, with id 1 and version 1"));
}

/// With the experiences of a peg that was put in, by a person and by an arm,
/// and one of an action without a record.
class LibraryOfExperiences : public LibraryCommand {
 protected:
  void SetUp() override {
    LibraryCommand::SetUp();
    SqliteActionStore store(dir_ / "a" / kDatabaseName,
                            SqliteActionStore::Mode::kExisting);
    ExperienceRecord experience;
    experience.action = "PlaceRoundPeg";
    experience.objects = {"round_peg_1", "base.round_1"};
    experience.agent = "person";
    experience.before = {"Clear(round_peg_1)", "Free(base.round_1)"};
    experience.after = {"Clear(round_peg_1)",
                        "PegInHole(round_peg_1, base.round_1)"};
    experience.demonstration = "assembly 5";
    store.Keep(experience, kBeforeRun);
    experience.agent = "robot";
    experience.after = experience.before;
    store.Keep(experience, kBeforeRun);
    experience.action = "Action1";
    store.Keep(experience, kBeforeRun);
  }
};

TEST_F(LibraryOfExperiences, SaysHowManyOfWhatThereAre) {
  const std::string list = Cell("library list --database a").output;
  EXPECT_THAT(list, testing::ContainsRegex(
                        "PlaceRoundPeg +2 experiences: 1 by an arm, 1 without "
                        "a change"));
  EXPECT_THAT(
      list, testing::ContainsRegex("Action1 +1 experience: .*no such action"));
  EXPECT_THAT(Cell("library show 1 --database a").output,
              HasSubstr("2 experiences: 1 by an arm"));
}

TEST_F(LibraryOfExperiences, AreExportedAndImported) {
  EXPECT_THAT(Cell("library export all.json --database a").output,
              HasSubstr("15 actions and 3 experiences are in all.json"));
  EXPECT_THAT(Cell("library import all.json --database new.db").output,
              HasSubstr("3 experiences imported, 0 already present"));
  EXPECT_THAT(Cell("library import all.json --database new.db").output,
              HasSubstr("0 experiences imported, 3 already present"));
  EXPECT_EQ(Cell("library export new.json --database new.db").code, 0);
  EXPECT_EQ(TextOf(dir_ / "new.json"), TextOf(dir_ / "all.json"));
  Replace(dir_ / "all.json", "PegInHole(round", "PegInHoel(round");
  const ShellResult strange =
      Cell("library import all.json --database other.db");
  EXPECT_EQ(strange.code, 1);
  EXPECT_THAT(strange.output,
              HasSubstr("the task has no predicate 'PegInHoel'; did you mean "
                        "'PegInHole'?"));
  EXPECT_FALSE(fs::exists(dir_ / "other.db"));
}

TEST_F(LibraryOfExperiences, AreEditedWithTheirActions) {
  EXPECT_THAT(Cell("library rename PlaceRoundPeg Plug --database a").output,
              HasSubstr("2 experiences stored, 2 removed"));
  EXPECT_THAT(Cell("library list --database a").output,
              testing::ContainsRegex("Plug +2 experiences"));
  EXPECT_THAT(Cell("library take-back 'assembly 5' --database a").output,
              HasSubstr("0 experiences stored, 1 removed"));
  EXPECT_EQ(Cell("library rollback 3 --database a").code, 0);
  EXPECT_THAT(Cell("library list --database a").output,
              testing::ContainsRegex("PlaceRoundPeg +2 experiences"));
}

TEST_F(LibraryOfExperiences, AreLearnedFromAndWrittenAsText) {
  const std::string left_out =
      "left out: experience 3: the library has no action Action1";
  const ShellResult learned = Cell("learn rules --library a");
  EXPECT_EQ(learned.code, 0);
  EXPECT_THAT(learned.output, HasSubstr(left_out));
  EXPECT_THAT(learned.output, HasSubstr("2 experiences, "));
  EXPECT_THAT(Cell("rules judge --library a").output, HasSubstr(left_out));
  fs::create_directories(dir_ / "text");
  const ShellResult record =
      Cell("rules record --library a --out text/a.experiences");
  EXPECT_EQ(record.code, 0);
  EXPECT_THAT(record.output, HasSubstr(left_out));
  EXPECT_THAT(record.output,
              HasSubstr("PlaceRoundPeg: 2 experiences, 1 without a change"));
  const std::string again = Cell("learn rules --experiences text").output;
  EXPECT_EQ(learned.output.substr(learned.output.find("2 experiences")), again);
}

TEST_F(LibraryCommand, AnEmptyFileIsNoLibraryAndStaysAsItIs) {
  std::ofstream(dir_ / "empty.db").close();
  for (const char* command : {"list", "rename A B"}) {
    const ShellResult run =
        Cell("library " + std::string(command) + " --database empty.db");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.output, HasSubstr("empty.db: is empty; name a library"));
  }
  EXPECT_EQ(TextOf(dir_ / "empty.db"), "");
}

TEST_F(LibraryCommand, AMissingDatabaseIsNamedAndNotMade) {
  const ShellResult run = Cell("library list --database nothing.db");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("nothing.db: there is no such library"));
  EXPECT_FALSE(fs::exists(dir_ / "nothing.db"));
}

TEST_F(LibraryCommand, AReadOnlyRunFolderIsReadAndStaysAsItIs) {
  const std::string list = Cell("library list --database a").output;
  std::ofstream(dir_ / "run.sh")
      << "set -e; mkdir tmp; export TMPDIR=$PWD/tmp\n"
      << "mount --bind a a && mount -o remount,ro,bind a\n"
      << kCell << " library list --database a\n"
      << "for change in 'import a/library.json' 'rename ScrewHead Turn' "
      << "'remove RemoveHead'; do\n"
      << "if " << kCell << " library $change --database a; then "
      << "exit 1; fi 2>>why\n"
      << "done\n"
      << "test -z \"$(ls tmp)\" && ls a/library.db-* 2>/dev/null && exit 1\n"
      << "exit 0\n";
  const ShellResult run =
      Shell("cd " + dir_.string() + " && " + InPrivateNetwork() +
            WithPrivateMounts() + "bash run.sh");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(run.output, list);
  std::istringstream lines(TextOf(dir_ / "why"));
  int num_lines = 0;
  for (std::string line; std::getline(lines, line); ++num_lines) {
    EXPECT_THAT(line, HasSubstr("a/library.db: cannot be opened for writing"));
  }
  EXPECT_EQ(num_lines, 3);
}

TEST_F(LibraryCommand, WhatARunHasLearnedOutlivesItAndCanBeChanged) {
  const std::string kRun =
      "sim --from-nothing --library my.db --demonstration two_pegs ";
  ASSERT_EQ(Cell(kRun + "--seed 3 --out first").code, 0);
  EXPECT_THAT(TextOf(dir_ / "first/run.yaml"), HasSubstr("my.db\", change: 0"));
  EXPECT_THAT(Cell("library list --verbose --database my.db").output,
              HasSubstr("by change 2: run first (build"));
  const ShellResult judged = Cell("rules judge --library first");
  EXPECT_EQ(judged.code, 1) << judged.output;
  EXPECT_THAT(judged.output, HasSubstr("from 1 start state: they do not"));
  EXPECT_THAT(judged.output,
              HasSubstr("not covered: PendulumPlaced(pendulum)"));
  const ShellResult rename =
      Cell("library rename Action1 PlugIn --database my.db");
  EXPECT_EQ(rename.code, 0) << rename.output;
  const ShellResult second = Cell(kRun + "--seed 4 --out second");
  EXPECT_THAT(second.output, HasSubstr("recognised PlugIn(round_peg_2"));
  EXPECT_THAT(TextOf(dir_ / "second/run.yaml"), HasSubstr("change: 3"));
  EXPECT_THAT(Cell("library list --verbose --database my.db").output,
              HasSubstr("shown 2 times by two_pegs 4 (build"));
  EXPECT_EQ(Cell("library take-back 'two_pegs 3' --database my.db").code, 0);
  const ShellResult again =
      Cell("library take-back 'two_pegs 3' --database my.db");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.output, HasSubstr("has taught nothing that is kept; "
                                      "nothing was changed"));
  EXPECT_EQ(Cell("library rollback 2 --database my.db").code, 0);
  EXPECT_THAT(Cell("library list --database my.db").output,
              testing::Not(HasSubstr("PlugIn")));
  EXPECT_THAT(Cell("library rollback 99 --database my.db").output,
              HasSubstr("change 99 is not kept; 1 to 6 are"));
  EXPECT_THAT(Cell("library changes --database my.db").output,
              HasSubstr("cell library take-back two_pegs 3"));
}

TEST_F(LibraryCommand, APartThatWasNeverShownIsRecognisedAndCounted) {
  const ShellResult run =
      Cell("eval substitution --runs 2 --seed 3 --rows rows");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("counted by the plan"));
  EXPECT_THAT(run.output, HasSubstr("2/2"));
}

TEST_F(LibraryCommand, AFullDiskLosesNothing) {
  // More than the disk has room for.
  std::string many = TextOf(dir_ / "a" / "library.json");
  const size_t begin = many.find("  {\n   \"id\": 11");
  const size_t end = many.find("  {\n   \"id\": 12");
  ASSERT_LT(begin, end);
  const std::string entry = many.substr(begin, end - begin);
  const std::string name = "\"RemoveHead\"";
  ASSERT_LT(entry.find(name), entry.size());
  std::string added;
  for (int i = 0; i < 500; ++i) {
    std::string copy = entry;
    added += copy.replace(copy.find(name), name.size(),
                          "\"More" + std::to_string(i) + "\"");
  }
  std::ofstream(dir_ / "many.json") << many.insert(end, added);
  std::ofstream(dir_ / "run.sh")
      << "set -e; mkdir small; mount -t tmpfs -o size=128k none small\n"
      << "cp a/library.db small/\n"
      << kCell << " library import many.json --database small || true\n"
      << kCell << " library list --database small | tail -1\n";
  const ShellResult run =
      Shell("cd " + dir_.string() + " && " + InPrivateNetwork() +
            WithPrivateMounts() + "bash run.sh");
  EXPECT_THAT(run.output,
              HasSubstr("small/library.db: the disk is full; free"));
  EXPECT_THAT(run.output, HasSubstr("15  PutDown("));
}

}  // namespace
}  // namespace cell
