// The cell as its users run it: installed, live, under systemd.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A process namespace, too: its manager is alone.
std::string Namespaces() {
  return InPrivateNetwork() + WithPrivateMounts() + "-p -f ";
}

constexpr int kNoManager = 77;

std::string Quoted(const std::string& text) {
  return "'" + text + "'";
}

// True if one of the lines of `text` holds both words.
bool HasLineWith(const std::string& text, const std::string& one,
                 const std::string& other) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(one) != std::string::npos &&
        line.find(other) != std::string::npos) {
      return true;
    }
  }
  return false;
}

// How many lines of `text` hold `word`.
int LinesWith(const std::string& text, const std::string& word) {
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.find(word) != std::string::npos ? 1 : 0;
  }
  return count;
}

class Systemd : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    if (Shell(Namespaces() + "true").code != 0) {
      GTEST_SKIP() << "no namespaces of its own may be had here";
    }
  }
  // With the build installed, but for the command alone.
  ShellResult Installed(const std::string& command) const {
    return Shell(Namespaces() + "sh -c " +
                 Quoted("mount -t tmpfs tmpfs /usr/local && cmake --install " +
                        std::string(CELL_BUILD_DIR) + " >/dev/null && " +
                        "cd /usr/local/lib/systemd/system && "
                        "export SYSTEMD_UNIT_PATH=$PWD:/usr/lib/systemd/system "
                        "&& " +
                        command));
  }
};

TEST_F(Systemd, TheUnitsHaveNoKeysThatSystemdRejects) {
  const ShellResult result = Installed(
      "systemd-analyze verify --man=no cell.target cell-cameras.target "
      "cell-*.service cell-robot-arm@left.service cell-camera-set@1.service");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.output, "");
}

TEST_F(Systemd, NoUnitIsExposedMoreThanTwoOfTen) {
  const ShellResult result = Installed(
      "for unit in cell-*.service; do systemd-analyze security --offline=true "
      "--threshold=20 --no-pager $unit >/run/lock/$$ 2>&1 || "
      "tail -1 /run/lock/$$; done");
  EXPECT_EQ(result.output, "");
}

TEST_F(Systemd, APersonIsWatchedThroughDeathsAndHangs) {
  const std::string source = CELL_SOURCE_DIR;
  const ShellResult run =
      Shell(Namespaces() + source + "/tests/system/under_systemd.sh " +
            CELL_BUILD_DIR + " " + source + "/tests/system/live_scenario.sh " +
            dir_.string() + " " + CELL_BUILD_DIR);
  if (run.code == kNoManager) {
    GTEST_SKIP() << "no systemd manager can run here: " << run.output;
  }
  ASSERT_EQ(run.code, 0) << run.output;
  std::cout << TextOf(dir_ / "restarts.txt");

  EXPECT_THAT(TextOf(dir_ / "status.txt"), HasSubstr("exit code 0"));
  const std::string told = TextOf(dir_ / "told.txt");
  for (const std::string service :
       {"tracker", "sec_builder", "recognizer", "predicate_estimator",
        "planner", "supervisor", "robot_arm@left", "robot_arm@right", "library",
        "motion_planner", "recorder"}) {
    EXPECT_GE(LinesWith(told, service + " has restarted"), 1) << service;
    EXPECT_THAT(TextOf(dir_ / "top.txt"), HasSubstr(service));
  }
  const size_t last_step = told.rfind("next: ");
  ASSERT_NE(last_step, std::string::npos) << told;
  EXPECT_THAT(told.substr(last_step), HasSubstr("the goal is reached"));
  // Each placement was recognised, or it is told that it was not: "No action
  // was recognised ...", "Found at ...".
  const std::string heard = TextOf(dir_ / "heard.txt");
  EXPECT_THAT(heard, HasSubstr("the episode ends"));
  const std::string all = told + heard;
  for (const std::string part :
       {"round_peg_1", "round_peg_2", "square_peg_1", "square_peg_2", "shaft",
        "separator", "pendulum", "head", "face_plate"}) {
    EXPECT_TRUE(HasLineWith(all, "recognised Place", part) ||
                HasLineWith(all, "recognised Screw", part) ||
                HasLineWith(all, "No recognised action", part) ||
                HasLineWith(all, "Found at", part))
        << part << " was placed and nothing said\n"
        << all << TextOf(dir_ / "glimpse.txt");
  }
  EXPECT_THAT(TextOf(dir_ / "check.txt"), Not(HasSubstr("DIFFERENT")));
  EXPECT_EQ(TextOf(dir_ / "left.txt"), "") << "left by the uninstall";
}

TEST_F(Systemd, UpSaysWhyACellCannotStart) {
  const std::string source = CELL_SOURCE_DIR;
  const ShellResult run =
      Shell(Namespaces() + source + "/tests/system/under_systemd.sh " +
            CELL_BUILD_DIR + " " + source + "/tests/system/up_reasons.sh " +
            dir_.string());
  if (run.code == kNoManager) {
    GTEST_SKIP() << "no systemd manager can run here: " << run.output;
  }
  ASSERT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(TextOf(dir_ / "environment.txt"),
              AllOf(HasSubstr("/cell/environment:CELL_DEMONSTRATION: "),
                    HasSubstr("(line 1)"), HasSubstr("exit code 1")));
  const std::string said = "tracker.yaml:period_ticks: 0 lies outside";
  EXPECT_THAT(TextOf(dir_ / "configuration.txt"),
              AllOf(HasSubstr("/usr/local/etc/cell/config/" + said),
                    Not(HasSubstr("runs/current")), HasSubstr("exit code 1")));
  EXPECT_EQ(TextOf(dir_ / "left.txt"), "") << "something was started";
  // What only the service finds is shown with it, and it is not tried again.
  EXPECT_THAT(TextOf(dir_ / "service.txt"),
              AllOf(HasSubstr("tracker: last output:\n"),
                    HasSubstr("/run/broken/config/" + said),
                    HasSubstr("journalctl --user -u 'cell-*'"),
                    HasSubstr("exit code 1")));
  EXPECT_EQ(TextOf(dir_ / "restarts.txt"), "0\n");
}

}  // namespace
}  // namespace cell
