// What commands print of strings that anybody may have sent or recorded.
#include <gmock/gmock.h>

#include <thread>

#include "cell/status_t.hpp"
#include "common/bus/event_log.h"
#include "common/bus/lcm_port.h"
#include "common/bus/private_network.h"
#include "tests/system/run_cell.h"

namespace cell {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kForged[] = "FAKE\x1b[2J\n0 findings\xe2\x80\xae\xc2\x9b\xff";

class Terminal : public RunCell {
 protected:
  static void SetUpTestSuite() { EnterPrivateNetwork(); }

  // What a person with a screen of 40 columns gets of `cell top`; meanwhile
  // another process talks on a channel with a forged name.
  std::string TopOn40Columns(const std::string& environment) const {
    std::jthread sender([](const std::stop_token& stop) {
      LcmPort port(LcmAddress().MainUrl());
      status_t status{};
      status.header.sender = 3;
      Bytes bytes(static_cast<size_t>(status.getEncodedSize()));
      status.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
      while (!stop.stop_requested()) {
        port.Publish(kForged, bytes);
        WaitForAny({&port}, 10);
      }
    });
    return Shell("cd " + dir_.string() + " && script -qec 'stty cols 40; " +
                 environment + " " + kCell +
                 " top --period 0.3 --reports 2' /dev/null")
        .output;
  }
};

TEST_F(Terminal, AForgedChannelInALogIsNamedAndNotObeyed) {
  EventLogWriter writer(dir_ / "log");
  writer.Write(1, kForged, Bytes(40));
  writer.Write(2, "FAKE", Bytes(40));
  writer.Flush();
  const ShellResult check = Cell("log check log");
  EXPECT_THAT(check.output, HasSubstr("FAKE\\x1b[2J\\n0 findings"));
  EXPECT_THAT(check.output, HasSubstr("\\u202e\\u009b\\xff"));
  EXPECT_THAT(check.output, Not(HasSubstr("\x1b")));
  EXPECT_THAT(check.output, Not(HasSubstr("\n0 findings")));
}

TEST_F(Terminal, TopNamesAForgedChannelWithin40Columns) {
  const std::string shown = TopOn40Columns("TERM=dumb");
  EXPECT_THAT(shown, HasSubstr("FAKE\\x1b[2J\\n0 findings"));
  EXPECT_THAT(shown, Not(HasSubstr("\x1b")));
  EXPECT_THAT(shown, Not(HasSubstr("\n0 findings")));
  std::istringstream lines(shown);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 41u) << line;  // with the terminal's \r
  }
}

TEST_F(Terminal, TopClearsTheScreenOnlyOfOneThatMayBe) {
  EXPECT_THAT(TopOn40Columns("TERM=xterm NO_COLOR="), HasSubstr("\x1b[2J"));
  EXPECT_THAT(TopOn40Columns("TERM=xterm NO_COLOR=1"), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace cell
