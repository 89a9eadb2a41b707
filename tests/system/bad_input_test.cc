// What a person may mistype: numbers on the command line, names in the files of
// a task. Each is refused before anything starts, and the answer says where.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// An option that takes a number: a command that ends at once if it is refused.
struct NumberOption {
  const char* command;
  const char* option;
  bool is_whole = true;
  bool may_be_negative = false;
};

class Numbers : public RunCell,
                public testing::WithParamInterface<NumberOption> {};

TEST_P(Numbers, AreDecimalAndInRangeOrRefusedByName) {
  std::vector<std::string> bad = {
      "010", "0x10", "7x", "''", "1,5", "1e999", "99999999999999999999999",
      "nan"};
  if (GetParam().is_whole) bad.insert(bad.end(), {"1.5", "1e3"});
  if (!GetParam().may_be_negative) bad.push_back("-1");
  const std::string program = std::string(GetParam().command).starts_with("vtb")
                                  ? std::string(CELL_BIN_DIR) + "/"
                                  : kCell + " ";
  for (const std::string& value : bad) {
    const ShellResult result =
        Shell("cd " + dir_.string() + " && timeout 20 " + program +
              GetParam().command + " " + GetParam().option + " " + value);
    EXPECT_EQ(result.code, 2) << result.output;
    const std::string shown = value == "''" ? "" : value;
    EXPECT_THAT(result.output,
                AllOf(HasSubstr(GetParam().option),
                      HasSubstr("'" + shown + "'"), HasSubstr("should be a ")))
        << GetParam().command;
  }
  EXPECT_TRUE(fs::is_empty(dir_));
}

INSTANTIATE_TEST_SUITE_P(
    Options, Numbers,
    testing::Values(NumberOption{"sim", "--seed"},
                    NumberOption{"demo", "--seed"},
                    NumberOption{"prepare --state-dir x", "--seed"},
                    NumberOption{"prepare --state-dir x", "--start"},
                    NumberOption{"episode start", "--seed"},
                    NumberOption{"episode start", "--deadline", false},
                    NumberOption{"goal x", "--deadline", false},
                    NumberOption{"eval watch", "--seed"},
                    NumberOption{"eval watch", "--runs"},
                    NumberOption{"eval watch", "--jobs"},
                    NumberOption{"doctor", "--min-free-mb"},
                    NumberOption{"top", "--period", false},
                    NumberOption{"top", "--reports"},
                    NumberOption{"record", "--seconds", false},
                    NumberOption{"view x", "--at", false},
                    NumberOption{"view x", "--azimuth", false, true},
                    NumberOption{"view x", "--elevation", false},
                    NumberOption{"explain x", "--at", false},
                    NumberOption{"sec similar", "--threshold", false},
                    NumberOption{"eval layers", "--noise-mm", false},
                    NumberOption{"eval stream", "--noise-mm", false},
                    NumberOption{"eval mistakes x", "--seed"},
                    NumberOption{"eval growth", "--seed"},
                    NumberOption{"rules record --out x", "--seed"},
                    NumberOption{"vtb", "--seed"},
                    NumberOption{"vtb", "--giveup", false}));

// CELL_SEED of the installed cell's environment comes to `prepare` and `vtb` as
// --seed, as it stands.
TEST_F(RunCell, TheLargestSeedIsTakenAndTheNextIsNot) {
  EXPECT_THAT(Cell("sim --seed 18446744073709551616 --out a").output,
              AllOf(HasSubstr("--seed: '18446744073709551616' is out of range"),
                    HasSubstr("18446744073709551615")));
  EXPECT_THAT(
      Cell("sim --seed 18446744073709551615 --demonstration none").output,
      Not(HasSubstr("--seed")));
}

TEST_F(RunCell, FilesWithoutARuleOrAnExperienceAreRefusedByName) {
  std::ofstream(dir_ / "empty.ndr") << "Clear 1 primitive binary\n";
  fs::create_directories(dir_ / "shown");
  std::ofstream(dir_ / "shown/empty.experiences") << "# a heading\n";
  for (const auto& [command, said] :
       {std::pair("rules show empty.ndr", "empty.ndr: holds no rule"),
        {"rules export empty.ndr --out a.pddl", "empty.ndr: holds no rule"},
        {"rules judge --experiences shown",
         "shown/empty.experiences: holds no experience"},
        {"learn rules --experiences shown --out a.ndr",
         "shown/empty.experiences: holds no experience"}}) {
    const ShellResult run = Cell(command);
    EXPECT_EQ(run.code, 1) << command;
    EXPECT_THAT(run.output, HasSubstr(said));
  }
  EXPECT_FALSE(fs::exists(dir_ / "a.pddl"));
  EXPECT_FALSE(fs::exists(dir_ / "a.ndr"));
}

TEST_F(RunCell, AnAddressIsDecimalAndOfMulticast) {
  for (const char* url :
       {"udpm://239.255.76.67:07667", "udpm://239.255.76.67:99999",
        "udpm://239.255.76.67:7667?ttl=256", "udpm://239.255.76.67:7667?ttl=01",
        "udpm://10.0.0.1:7667", "udpm://239.255.76.670:7667"}) {
    const ShellResult result =
        Cell(std::string("top --reports 1 --url '") + url + "'");
    EXPECT_NE(result.code, 0);
    EXPECT_THAT(result.output, HasSubstr(std::string("'") + url + "'"));
  }
}

TEST_F(RunCell, RecordedFramesFromElsewhereAreKeptInTheRun) {
  fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
           fs::copy_options::recursive);
  const fs::path file = dir_ / "deploy/config/camera_set.yaml";
  const std::string edit =
      "sed -i 's|^device: .*|device: recorded|; s|folder: "
      ".*|folder: " +
      (dir_ / "frames").string() + "|' " + file.string();
  ASSERT_EQ(Shell(edit).code, 0);
  const std::string prepare = "prepare --deploy deploy --state-dir state";
  const ShellResult refused = Cell(prepare);
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output,
              AllOf(HasSubstr("camera_set.yaml:recorded.folder: there is no"),
                    HasSubstr("(line ")));

  fs::create_directories(dir_ / "frames/1");
  std::ofstream(dir_ / "frames/1/camera.yaml") << "fx: 1\n";
  ASSERT_EQ(Cell(prepare).code, 0);
  const fs::path run = dir_ / "state/runs/current/deploy";
  EXPECT_EQ(TextOf(run / "tasks/cranfield/recorded/1/camera.yaml"), "fx: 1\n");
  EXPECT_THAT(TextOf(run / "config/camera_set.yaml"),
              HasSubstr("folder: recorded\n"));
}

/// A fault in a file of the deployment: sed, and what is said.
struct Mistake {
  const char* name;
  const char* file;
  const char* sed;
  const char* said;  ///< file:key and why
};

class Task : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
             fs::copy_options::recursive);
  }
  void Edit(const std::string& file, const std::string& sed) const {
    const std::string path = (dir_ / "deploy" / file).string();
    const std::string before = TextOf(path);
    ASSERT_EQ(Shell("sed -i '" + sed + "' " + path).code, 0);
    ASSERT_NE(TextOf(path), before) << sed;
  }
};

class Mistaken : public Task, public testing::WithParamInterface<Mistake> {};

// What a run asks for is held against the files before they are copied.
TEST_F(Task, OfARunThatCannotBeginIsNamedAsItsUserKnowsIt) {
  Edit("config/camera_set.yaml", "s/^device: rendered/device: rendred/");
  for (const char* command :
       {"sim --out a --cameras", "demo --out a --cameras",
        "prepare --state-dir state --cameras", "doctor"}) {
    EXPECT_THAT(
        Cell(std::string(command) + " --deploy deploy").output,
        AllOf(HasSubstr((dir_ / "deploy/config/camera_set.yaml").string() +
                        ":device: 'rendred' is neither"),
              HasSubstr("(line "), Not(HasSubstr("a/deploy"))))
        << command;
  }
  const ShellResult step =
      Cell("sim --out a --help-steps PlaceNothing --deploy deploy");
  EXPECT_EQ(step.code, 1);
  EXPECT_THAT(step.output,
              AllOf(HasSubstr("--help-steps PlaceNothing: the robot has no"),
                    HasSubstr("ScrewHead"), Not(HasSubstr("planner.yaml"))));
  EXPECT_FALSE(fs::exists(dir_ / "a"));
}

TEST_P(Mistaken, IsRefusedByEveryCommandBeforeAnythingStarts) {
  Edit(GetParam().file, GetParam().sed);
  for (const char* command : {"sim --out a --demonstration two_pegs",
                              "demo --out a", "prepare --state-dir state",
                              "eval watch --runs 1 --rows rows", "doctor"}) {
    const ShellResult run = Shell("cd " + dir_.string() + " && timeout 50 " +
                                  kCell + " " + command + " --deploy deploy");
    EXPECT_EQ(run.code, 1) << command << "\n" << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr(GetParam().said), HasSubstr("(line ")))
        << command;
  }
  EXPECT_FALSE(fs::exists(dir_ / "a"));
  EXPECT_FALSE(fs::exists(dir_ / "state/runs"));
}

constexpr char kDomain[] = "tasks/cranfield/domain.yaml";
constexpr char kParts[] = "tasks/cranfield/parts.yaml";
constexpr char kSuccess[] = "tasks/cranfield/success.yaml";
constexpr char kScripts[] = "tasks/cranfield/demonstrators.yaml";

INSTANTIATE_TEST_SUITE_P(
    Mistakes, Mistaken,
    testing::Values(
        Mistake{"NoAgent", kDomain, "0,/agents: .person./s//agents: []/",
                "agents: names no agent"},
        Mistake{"UndoesItself", kDomain,
                "s/^  RemoveHead:/&\\n    undoes: RemoveHead/",
                "RemoveHead.undoes: an action cannot undo itself"},
        Mistake{"Contradiction", kDomain,
                "s/context: .\"Held(X, left)\"/context: [\"Held(X, left)\", "
                "\"not Held(X, left)\"/",
                "contradicts another literal"},
        Mistake{"ContradictionWithAny", kDomain,
                "s/context: .\"Held(X, A)\"./context: [\"Held(X, A)\", \"not "
                "Held(X, _)\"]/",
                "contradicts another literal"},
        Mistake{"GoalOfNoDomain", kScripts, "s/^goal: assembled/goal: done/",
                "demonstrators.yaml:goal: domain.yaml has no goal"},
        Mistake{"SuccessOfNoGoal", kSuccess, "s/^goal: assembled/goal: done/",
                "success.yaml:goal: domain.yaml has no goal 'done'; it has: "},
        Mistake{"SuccessLeavesOut", kSuccess, "/^  HeadScrewed:/d",
                "success.yaml:seated: does not mention HeadScrewed(head)"},
        Mistake{
            "HingeWithoutLimits", kParts,
            "/^  head:$/i\\  lid: {type: head, symmetry_order: 1, density: "
            "900, colour: [1, 1, 1], pieces: [{kind: box, center: [0, 0, "
            "0], size: [9, 9, 9]}], joint: {on: base, xyz: [0, 0, 0], kind: "
            "hinge, axis: [0, 0, 1], at: [0, 0, 0], friction: 0, damping: "
            "0}, handle: {xyz: [50, 0, 0], width: 9}}",
            "parts.yaml:parts.lid.joint: a hinge needs limits_deg: "
            "[lower, upper]"},
        Mistake{"EmptyGoal", kDomain, "s/^  round_pegs:/  nothing: []\\n&/",
                "goals.nothing: has no literals"},
        Mistake{"OtherArm", "tasks/cranfield/cell.yaml",
                "s/^  left:$/  links:/", "domain.yaml:"},
        Mistake{"NoSuchGrip", kParts, "s/three_finger_ball/three_finger_bowl/",
                "parts.yaml:parts.head.grasps[0]: no hand of cell.yaml has the "
                "grip"},
        Mistake{"PlacementThatDoesNotFit", kScripts,
                "s/part: shaft, site: shaft_hole/part: shaft, site: "
                "round_hole/",
                "placements.shaft.site: no part of the type"},
        Mistake{"PlacedTwice", kScripts,
                "s/place: .round_pegs./place: [round_pegs, round_pegs]/",
                "is named twice"},
        Mistake{"NoSuchService", "config/roster.yaml",
                "s/name: recognizer/name: recogniser/", "there is no service"},
        Mistake{"TypeOfNoPart", kDomain,
                "s/arguments: {X: movable}/arguments: {X: object}/",
                "domain.yaml:actions."},
        Mistake{"WideOpening", kParts, "0,/opening: 20/s//opening: wide/",
                "parts.yaml:parts.base.sites[0].opening: cannot be read as a "
                "number"},
        Mistake{"KeyTwice", kParts, "s/^  head:$/  shaft: {}\\n&/",
                "parts.yaml:parts.shaft: the key already exists"},
        Mistake{"Octal", "config/planner.yaml",
                "s/max_attempts: 3/max_attempts: 010/",
                "planner.yaml:execution.max_attempts: cannot be read as a "
                "whole number"},
        Mistake{"NeverAsks", "config/planner.yaml",
                "s/sense_period_ms: 200/sense_period_ms: 0/",
                "planner.yaml:execution.sense_period_ms"}),
    [](const auto& test_info) { return test_info.param.name; });

}  // namespace
}  // namespace cell
