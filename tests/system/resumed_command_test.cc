// Long commands that go on after an interruption, as users run them.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/system/run_cell.h"
#include "tests/unit/ladder_ppddl.h"

namespace cell {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ResumedCommand : public RunCell {
 protected:
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name, std::ios::binary) << text;
  }
  std::string Read(const std::string& name) const {
    std::ifstream file(dir_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Without the memory, which depends on the process.
  std::string PlanWith(const std::string& options) const {
    const ShellResult result =
        Cell("plan --ppddl domain.pddl problem.pddl " + options);
    EXPECT_EQ(result.code, 0) << result.output;
    return result.output.substr(0, result.output.rfind(" MB; "));
  }
};

TEST_F(ResumedCommand, APlanIsFoundFurtherFromWhereTheBudgetEnded) {
  Write("domain.pddl", kRover);
  Write("problem.pddl", LadderProblem(8));
  const std::string whole = PlanWith("--fewest");
  EXPECT_THAT(whole, HasSubstr("proven the fewest"));
  Cell("plan --ppddl domain.pddl problem.pddl --save s --max-expansions 40");
  const std::string half = Read("s");
  EXPECT_FALSE(half.empty());
  EXPECT_THAT(PlanWith("--fewest --save s --resume"),
              HasSubstr("proven the fewest"));
  // Whole now, and once more.
  EXPECT_NE(Read("s"), half);
  const std::string again = PlanWith("--fewest --save s --resume");
  EXPECT_EQ(again, PlanWith("--fewest --save s --resume"));
  EXPECT_EQ(PlanWith("--fewest --save new --resume"), whole);
}

TEST_F(ResumedCommand, ASearchIsNeitherOverwrittenNorMistaken) {
  Write("domain.pddl", kRover);
  Write("problem.pddl", LadderProblem(5));
  PlanWith("--save s");
  const std::string saved = Read("s");
  const std::string plan = "plan --ppddl domain.pddl problem.pddl --save s";
  EXPECT_THAT(Cell(plan).output, HasSubstr("--resume"));
  EXPECT_THAT(Cell(plan + " --resume --precision 0.1").output,
              HasSubstr("s: holds no search"));
  Write("problem.pddl", LadderProblem(6));
  EXPECT_THAT(Cell(plan + " --resume").output, HasSubstr("s: holds no search"));
  Write("problem.pddl", LadderProblem(5));
  EXPECT_EQ(Read("s"), saved);
  Write("s", saved.substr(0, saved.size() / 2));
  const ShellResult cut = Cell(plan + " --resume");
  EXPECT_EQ(cut.code, 1);
  EXPECT_THAT(cut.output, HasSubstr("remove it to begin anew"));
  EXPECT_THAT(Cell("plan --ppddl domain.pddl problem.pddl --resume").output,
              HasSubstr("--save"));
}

TEST_F(ResumedCommand, RulesAreLearnedFurtherAsIfNothingHadHappened) {
  Write("symbols.dat",
        "lift 1 action binary\ndrop 1 action binary\n"
        "free 1 primitive binary\nheld 1 primitive binary\n");
  std::string data;
  for (int i = 0; i < 4; ++i) {
    data += "free(1) free(2)\nlift(1)\nheld(1) free(2)\n";
    data += "drop(1)\nfree(1) free(2)\nlift(2)\nheld(2) free(1)\ndrop(2)\n";
  }
  Write("data.dat", data + "free(1) free(2)\n");
  EXPECT_EQ(Cell("rules learn . --out whole").code, 0);
  const ShellResult first = Cell("rules learn . --rows rows --out first");
  ASSERT_EQ(first.code, 0) << first.output;
  const std::string rows = Read("rows");
  const size_t end = rows.rfind('\n', rows.size() - 2) + 1;
  ASSERT_EQ(std::ranges::count(rows, '\n'), 3) << "two actions";
  // As if it had been killed while it wrote the second row.
  Write("rows", rows.substr(0, end + 5));
  const ShellResult second =
      Cell("rules learn . --rows rows --resume --out second");
  EXPECT_EQ(second.code, 0) << second.output;
  EXPECT_EQ(second.output, first.output);
  EXPECT_EQ(Read("rows"), rows);
  EXPECT_EQ(Read("first"), Read("whole"));
  EXPECT_EQ(Read("second"), Read("whole"));
  EXPECT_THAT(Cell("rules learn . --rows rows").output, HasSubstr("--resume"));
}

// How many runs there are may change, nothing else.
TEST_F(ResumedCommand, AnEvaluationGoesOnWithTheSameOptionsOnly) {
  const std::string eval = "eval rexd --success 1 --rows rows --episodes ";
  const ShellResult first = Cell(eval + "1 --runs 1");
  ASSERT_EQ(first.code, 0) << first.output;
  const std::string rows = Read("rows");
  const auto expect_refused = [&](const std::string& command,
                                  const std::string& why) {
    const ShellResult result = Cell(command + " --resume");
    EXPECT_EQ(result.code, 1) << command;
    EXPECT_THAT(result.output, AllOf(HasSubstr("rows: "), HasSubstr(why),
                                     HasSubstr("another --rows")))
        << command;
    EXPECT_THAT(result.output, Not(HasSubstr("success"))) << "no figures";
    EXPECT_EQ(Read("rows"), rows) << command;
  };
  expect_refused(eval + "2", "--episodes was 1, now it is 2");
  expect_refused(eval + "1 --teacher noisy", "--teacher was sure");
  expect_refused(eval + "1 --without types", "--without was none");
  expect_refused(eval + "1 --skip-no-ops", "--skip-no-ops was no");
  Write("task", TextOf(std::string(CELL_SOURCE_DIR) +
                       "/deploy/tasks/cranfield/learning/dead_ends.rules"));
  expect_refused(eval + "1 --task-file task", "the task file is another");
  expect_refused("eval watch --rows rows", "they are of 'cell eval rexd'");
  expect_refused("eval excuses --rows rows", "they are of 'cell eval rexd'");
  const ShellResult more = Cell(eval + "1 --runs 2 --jobs 1 --resume");
  EXPECT_EQ(more.code, 0) << more.output;
  EXPECT_TRUE(Read("rows").starts_with(rows)) << "the row that was there";
}

TEST_F(ResumedCommand, AnEvaluationGoesOnWithTheSameFilesOnly) {
  std::filesystem::copy(std::string(CELL_SOURCE_DIR) + "/deploy",
                        dir_ / "deploy",
                        std::filesystem::copy_options::recursive);
  const std::string eval =
      "eval sufficient --deploy deploy --runs 1 --rows rows";
  EXPECT_THAT(Cell(eval).output, HasSubstr("(1 of 1 runs)"));
  EXPECT_THAT(Cell(eval + " --resume").output, HasSubstr("(1 of 1 runs)"));
  std::ofstream(dir_ / "deploy/config/tracker.yaml", std::ios::app) << "\n";
  const ShellResult changed = Cell(eval + " --resume");
  EXPECT_EQ(changed.code, 1);
  EXPECT_THAT(changed.output, HasSubstr("config/tracker.yaml is another"));
}

TEST_F(ResumedCommand, RulesOfARowThatAreNoRulesAreNamed) {
  Write("symbols.dat",
        "lift 1 action binary\nfree 1 primitive binary\n"
        "held 1 primitive binary\n");
  Write("data.dat", "free(1)\nlift(1)\nheld(1)\n");
  const std::string learn = "rules learn . --rows rows";
  ASSERT_EQ(Cell(learn).code, 0);
  const std::string rows = Read("rows");
  const std::string header = rows.substr(0, rows.find('\n') + 1);
  for (const char* fields : {R"("rules":"foo","score":1)",
                             R"("rules":7,"score":1)", R"("rules":"")"}) {
    Write("rows", header + "{\"key\":\"lift\"," + fields + "}\n");
    const ShellResult result = Cell(learn + " --resume");
    EXPECT_EQ(result.code, 1) << fields;
    EXPECT_THAT(result.output, AllOf(HasSubstr("rows: line 2: row 'lift': "),
                                     Not(HasSubstr("json.exception"))));
  }
  Write("data.dat", "free(1)\nlift(1)\nheld(1)\nlift(1)\nheld(1)\n");
  EXPECT_THAT(Cell(learn + " --resume").output,
              HasSubstr("the file of experiences is another"));
  EXPECT_THAT(Cell("eval rules . --rows rows --resume").output,
              HasSubstr("they are of 'cell rules learn'"));
}

TEST_F(ResumedCommand, AResultOfAPlanReplacesNoFile) {
  Write("domain.pddl", kRover);
  Write("problem.pddl", LadderProblem(5));
  const std::string plan = "plan --ppddl domain.pddl problem.pddl ";
  for (const std::string option : {"--json ", "--picture ", "--save "}) {
    const ShellResult run = Cell(plan + option + "problem.pddl");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.output, HasSubstr("problem.pddl: exists")) << option;
  }
  EXPECT_EQ(Read("problem.pddl"), LadderProblem(5));
  EXPECT_THAT(Cell(plan + "--json x --picture ./x").output,
              HasSubstr("./x: would be written twice"));
  EXPECT_EQ(Cell(plan + "--json new/x --picture new/y").code, 0);
  EXPECT_THAT(Read("new/x"), HasSubstr("\"plan\""));
}

}  // namespace
}  // namespace cell
