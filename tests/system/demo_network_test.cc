// Commands for a cell that runs find the demo of the same user, whose network
// is its own.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "common/bus/private_network.h"
#include "services/cell/running/process_group.h"
#include "tests/system/run_cell.h"

namespace cell {

using namespace cli;
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DemoNetwork : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    EnterPrivateNetwork();
  }
  void Start(const std::string& name) {
    demos_.Start(name, kCell,
                 {"demo", "--pace", "realtime", "--demonstration", "two_pegs",
                  "--out", (dir_ / name).string()},
                 dir_ / (name + ".out"));
  }
  /// Until it says what happens in the episode, at most for a minute.
  bool AwaitEpisode(const std::string& name) const {
    for (int i = 0; i < 600; ++i) {
      if (TextOf(dir_ / (name + ".out")).find("episode 1") !=
          std::string::npos) {
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  void TearDown() override {
    constexpr int kGraceMs = 10'000;
    demos_.StopAll(kGraceMs);
    RunCell::TearDown();
  }

  ProcessGroup demos_;
};

TEST_F(DemoNetwork, TheOnlyDemoIsFound) {
  Start("one");
  ASSERT_TRUE(AwaitEpisode("one")) << TextOf(dir_ / "one.out");
  const ShellResult hold = Cell("hold");
  EXPECT_EQ(hold.code, 0) << hold.output;
  EXPECT_THAT(hold.output, AllOf(HasSubstr("in the network of `cell demo`"),
                                 HasSubstr((dir_ / "one").string())));
  EXPECT_EQ(Cell("resume").code, 0);
  EXPECT_EQ(Cell("goal assembled").code, 0);
  EXPECT_THAT(Cell("top --reports 1").output, HasSubstr("recognizer"));
  const ShellResult record = Cell("record --seconds 1 --out glimpse");
  EXPECT_THAT(record.output, HasSubstr("messages of"));
}

// As root is in many containers.
TEST_F(DemoNetwork, RootWithoutTheRightToSetUpNetworksRunsADemoAllTheSame) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  const std::string restricted =
      "setpriv --bounding-set -net_admin --inh-caps -net_admin ";
  demos_.Start("one", "/usr/bin/setpriv",
               {"--bounding-set", "-net_admin", "--inh-caps", "-net_admin",
                kCell, "demo", "--pace", "realtime", "--demonstration",
                "two_pegs", "--out", (dir_ / "one").string()},
               dir_ / "one.out");
  ASSERT_TRUE(AwaitEpisode("one")) << TextOf(dir_ / "one.out");
  const ShellResult hold = Shell(restricted + kCell + " hold");
  EXPECT_EQ(hold.code, 0) << hold.output;
}

TEST_F(DemoNetwork, AmongSeveralOneChooses) {
  Start("one");
  Start("two");
  ASSERT_TRUE(AwaitEpisode("one"));
  ASSERT_TRUE(AwaitEpisode("two"));
  const ShellResult unclear = Cell("hold");
  EXPECT_EQ(unclear.code, 1);
  EXPECT_THAT(unclear.output,
              AllOf(HasSubstr("several of your demos are running"),
                    HasSubstr((dir_ / "one").string()),
                    HasSubstr((dir_ / "two").string())));
  const size_t at = unclear.output.find("--demo ");
  const std::string choice =
      unclear.output.substr(at, unclear.output.find(" (", at) - at);
  EXPECT_EQ(Cell("hold " + choice).code, 0);
  const ShellResult none = Cell("hold --demo 1");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.output,
              HasSubstr("--demo 1: none of your `cell demo` runs"));
}

TEST_F(DemoNetwork, AnEndedDemoIsNotFound) {
  Start("one");
  ASSERT_TRUE(AwaitEpisode("one"));
  demos_.Kill("one", SIGKILL);  // leaves its registration behind
  const ShellResult hold = Cell("hold --demo 1");
  EXPECT_THAT(hold.output, HasSubstr("Running: none"));
}

}  // namespace
}  // namespace cell
