// Stock tools around the cell: lcm-logger writes a run in real time,
// lcm-logplayer plays it into services that follow.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/system/run_cell.h"
#include "tests/system/stock_logger.h"

namespace cell {
namespace {

using testing::HasSubstr;
using testing::Not;

class Follow : public RunCell {
 protected:
  // Plays `stock`, but for what the followers say themselves.
  ShellResult PlayInto(const std::string& log) const {
    std::ofstream(dir_ / "play") << R"(
ip link set lo up && ip route add 224.0.0.0/4 dev lo
url='udpm://239.255.76.67:7667?ttl=0'
$BIN/sec_builder --follow --deploy $DEPLOY & first=$!
$BIN/recognizer --follow --deploy $DEPLOY & second=$!
until [ $(grep -c :1DF3 /proc/net/udp) -ge 2 ]; do :; done
lcm-logplayer --lcm-url="$url" -e '^(?!(KEY_FRAME|ACTION)$).*' $LOG >player.txt
wait $first && wait $second
)";
    return Shell("cd " + dir_.string() + " && LOG=" + log +
                 " BIN=" CELL_BIN_DIR " DEPLOY=" CELL_SOURCE_DIR "/deploy " +
                 InPrivateNetwork() + "bash ./play");
  }
};

TEST_F(Follow, ServicesThatFollowAStockLogPublishWhatItHolds) {
  const ShellResult run = RunBesideLcmLogger(dir_, "--seed 3 --pace realtime");
  ASSERT_EQ(run.code, 0) << run.output;
  const ShellResult convert = Cell("log convert stock --out canonical");
  ASSERT_EQ(convert.code, 0) << convert.output;  // nothing is lost

  const ShellResult play = PlayInto("stock");
  EXPECT_EQ(play.code, 0) << play.output;
  EXPECT_THAT(play.output, HasSubstr("sec_builder: followed"));
  EXPECT_THAT(play.output, HasSubstr("recognizer: followed"));
  EXPECT_THAT(play.output, Not(HasSubstr("differs from the log")));
  EXPECT_THAT(play.output, Not(HasSubstr(" 0 messages")));
  std::cout << play.output;
}

}  // namespace
}  // namespace cell
