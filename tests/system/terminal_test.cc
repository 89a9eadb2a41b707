// Terminals and untrusted text: what commands print of received messages.
#include <gmock/gmock.h>

#include <csignal>
#include <cstdio>
#include <thread>

#include "cell/status_t.hpp"
#include "common/bus/event_log.h"
#include "common/bus/lcm_port.h"
#include "common/bus/message.h"
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

  // What a person with a screen of 40 columns gets of `cell top` until it
  // shows `awaited`; meanwhile another process talks on and of channels with
  // forged names.
  std::string TopOn40Columns(const std::string& environment,
                             const std::string& awaited) const {
    std::jthread sender([](const std::stop_token& stop) {
      LcmPort port(LcmAddress().MainUrl());
      status_t status{};
      status.header.sender = 3;
      status.service = "tracker";
      status.num_counters = 1;
      status.counters.resize(1);
      status.counters[0].name = std::string("rejected:") + kForged;
      Bytes bytes(static_cast<size_t>(status.getEncodedSize()));
      status.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
      while (!stop.stop_requested()) {
        port.Publish("FAKE\x1b[3J", bytes);
        port.Publish(kStatusChannel, bytes);
        WaitForAny({&port}, 10);
      }
    });
    const std::string command =
        "script -qec 'stty cols 40; echo $$; exec env " + environment + " " +
        kCell + " top --period 0.1 --reports 300' /dev/null";
    std::FILE* top = popen(command.c_str(), "r");
    int pid = 0;
    EXPECT_EQ(std::fscanf(top, "%d", &pid), 1);
    std::string shown;
    bool is_stopped = pid <= 0;
    for (int c = 0; (c = std::fgetc(top)) != EOF;) {
      shown += static_cast<char>(c);
      if (is_stopped || shown.find(awaited) == std::string::npos) continue;
      kill(pid, SIGTERM);
      is_stopped = true;
    }
    pclose(top);
    return shown;
  }
};

TEST_F(Terminal, AForgedChannelInALogIsNamedAndNotObeyed) {
  EventLogWriter writer(dir_ / "log");
  for (int i = 0; i < 3; ++i) writer.Write(0, "FAKE", Bytes(40));
  writer.Write(1, kForged, Bytes(40));  // its stamp is worth a line
  writer.Flush();
  const ShellResult check = Cell("log check log");
  EXPECT_THAT(check.output, HasSubstr("FAKE\\x1b[2J\\n0 findings"));
  EXPECT_THAT(check.output, HasSubstr("\\u202e\\u009b\\xff"));
  EXPECT_THAT(check.output, Not(HasSubstr("\x1b")));
  EXPECT_THAT(check.output, Not(HasSubstr("\n0 findings")));
}

TEST_F(Terminal, TopNamesAForgedChannelWithin40Columns) {
  const std::string shown = TopOn40Columns("TERM=dumb", "FAKE\\x1b[3J");
  EXPECT_THAT(shown, HasSubstr("FAKE\\x1b[3J"));
  EXPECT_THAT(shown, HasSubstr("FAKE\\x1b[2J\\n0 findings"));
  EXPECT_THAT(shown, Not(HasSubstr("\x1b")));
  EXPECT_THAT(shown, Not(HasSubstr("\n0 findings")));
  std::istringstream lines(shown);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 41u) << line;  // with the terminal's \r
  }
}

TEST_F(Terminal, TopClearsTheScreenOnlyWhereCodesAreAllowed) {
  EXPECT_THAT(TopOn40Columns("TERM=xterm NO_COLOR=", "messages from outside"),
              HasSubstr("\x1b[2J"));
  EXPECT_THAT(TopOn40Columns("TERM=xterm NO_COLOR=1", "messages from outside"),
              Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace cell
