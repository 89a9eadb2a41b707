// The cell assembles by itself over LCM: processes that are killed while they
// take, carry and insert leave the same bytes as in one process.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "cell/arm_report_t.hpp"
#include "common/bus/run_log.h"
#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Of the first parts alone, in a deployment whose episodes end early.
class ExecutionCommand : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    fs::copy(fs::path(CELL_SOURCE_DIR) / "deploy", dir_ / "deploy",
             fs::copy_options::recursive);
    const fs::path scripts =
        dir_ / "deploy" / "tasks" / "cranfield" / "demonstrators.yaml";
    std::string text = TextOf(scripts);
    const std::string script = "execution: {agent: robot";
    const std::string duration = "max_duration_s: ";
    const size_t at = text.find(duration, text.find(script));
    ASSERT_LT(at, text.size());
    const size_t end = text.find('}', at);
    text.replace(at, end - at, duration + "44");
    std::ofstream(scripts) << text;
  }
  std::string HashOfExecution(const std::string& arguments) const {
    return Hash(arguments +
                " --deploy deploy --demonstration execution --seed 3");
  }
};

TEST_F(ExecutionCommand, TheSameSeedGivesTheSameBytesOverLcmAndInOneProcess) {
  EXPECT_EQ(HashOfExecution("demo --out a"), HashOfExecution("sim --out b"));
}

TEST_F(ExecutionCommand, KilledServicesComeBackAsTheyDoInOneProcess) {
  // While the right arm reaches for its first part, carries it and seats it:
  // far enough from the ends of these phases, since a busy machine starts dead
  // services later.
  const std::vector<std::string> kills = {
      "tracker@320",  "supervisor@350",  "planner@365",  "robot_arm@right@380",
      "tracker@1070", "supervisor@1100", "planner@1115", "robot_arm@right@1150",
      "tracker@2100", "supervisor@2150", "planner@2165", "robot_arm@right@2200",
  };
  std::string arguments = "demo --out a";
  for (const std::string& kill : kills) arguments += " --kill " + kill;
  const std::string lcm = HashOfExecution(arguments);
  const RunLog log = RunLog::Load(dir_ / "a");
  EXPECT_THAT(log.problems(), testing::IsEmpty());
  size_t num_deaths = 0;
  std::string phase;
  std::set<std::string> phases;  // in which the arm's own service has died
  for (const auto& [k, entry] : log.ticks()) {
    for (const joined_t& joined : entry.manifest.joined) {
      num_deaths += joined.death_tick >= 0;
      if (joined.death_tick >= 0 && joined.name == "robot_arm@right") {
        phases.insert(phase);
      }
    }
    for (const Message& message : entry.messages) {
      if (message.channel != "ARM_REPORT_RIGHT") continue;
      arm_report_t report;
      report.decode(message.bytes->data(), 0,
                    static_cast<int>(message.bytes->size()));
      phase = report.phase;
    }
  }
  EXPECT_EQ(num_deaths, kills.size());
  EXPECT_THAT(phases, testing::ElementsAre(testing::AnyOf("carry", "lift"),
                                           "reach", "seat"));
  EXPECT_EQ(lcm, HashOfExecution("sim --out b --deaths-of a"));
  const ShellResult replay = Cell("replay a --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
  for (const char* service : {"vtb", "tracker", "planner", "supervisor",
                              "robot_arm@left", "robot_arm@right"}) {
    EXPECT_THAT(replay.output, HasSubstr(service));
  }
}

TEST_F(ExecutionCommand, AStopThatNobodyClearsEndsTheRunAndSaysWhy) {
  const fs::path vtb = dir_ / "deploy" / "config" / "vtb.yaml";
  std::string text = TextOf(vtb);
  const std::string limit = "stop_force_n: 150";
  ASSERT_NE(text.find(limit), std::string::npos);
  text.replace(text.find(limit), limit.size(), "stop_force_n: 12");
  std::ofstream(vtb) << text;
  const ShellResult sim =
      Cell("sim --deploy deploy --demonstration execution --seed 1001 --out a");
  EXPECT_EQ(sim.code, 1);
  EXPECT_THAT(sim.output,
              testing::ContainsRegex(
                  "why: .*no operator.*right arm.*gripper.* measured "
                  "[0-9.]+ N, more than the 12[.0]* N allowed"));
}

}  // namespace
}  // namespace cell
