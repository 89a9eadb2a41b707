// cell log on what users have: recordings of lcm-logger, broken files.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <tuple>

#include "cell/step_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/event_log.h"
#include "common/bus/message.h"
#include "tests/system/run_cell.h"
#include "tests/system/stock_logger.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class LogCommand : public RunCell {
 protected:
  using Event = std::tuple<int64_t, std::string, Bytes>;
  std::multiset<Event> EventsOf(const fs::path& path) const {
    EventLogReader reader(path);
    reader.Finish();
    std::multiset<Event> events;
    while (const auto event = reader.Next()) {
      events.emplace(event->utime, event->channel, event->bytes);
    }
    return events;
  }
};

TEST_F(LogCommand, ARecordingOfLcmLoggerIsTheRecordersButForWhatIsNamed) {
  const ShellResult run = RunBesideLcmLogger(dir_, "--seed 3");
  ASSERT_EQ(run.code, 0) << run.output;
  const ShellResult convert = Cell("log convert stock --out converted");
  EXPECT_THAT(convert.output, HasSubstr("a stock recording")) << convert.output;
  const auto own = EventsOf(dir_ / "own/cell-0001.lcmlog");
  const auto converted = EventsOf(dir_ / "converted");
  EXPECT_TRUE(std::includes(own.begin(), own.end(), converted.begin(),
                            converted.end()));
  // At full speed lcm-logger may lose some: then each is named.
  std::istringstream lines(convert.output);
  size_t num_named = 0;
  for (std::string line; std::getline(lines, line);) {
    num_named += line.find("is lost") != std::string::npos;
  }
  EXPECT_EQ(converted.size() + num_named, own.size()) << convert.output;
  EXPECT_EQ(convert.code, num_named == 0 ? 0 : 1);
  if (num_named == 0) {
    EXPECT_EQ(TextOf(dir_ / "converted"),
              TextOf(dir_ / "own/cell-0001.lcmlog"));
  }
  std::cout << own.size() << " messages, lcm-logger lost " << num_named << "\n";
}

TEST_F(LogCommand, CheckAndRepairOfADamagedRunSayWhatIsLost) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  const ShellResult whole = Cell("log check a --stock");
  EXPECT_EQ(whole.code, 0) << whole.output;
  EXPECT_THAT(whole.output, HasSubstr("\nwhole\n"));
  const std::string good = TextOf(dir_ / "a/cell-0001.lcmlog");
  std::string bad = good;
  bad[bad.size() / 4] = static_cast<char>(bad[bad.size() / 4] ^ 8);
  bad.erase(bad.size() / 3, 1);
  std::ofstream(dir_ / "bad") << bad;
  const ShellResult check = Cell("log check bad --stock");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(check.output,
              AllOf(HasSubstr("bad byte "), HasSubstr(": no whole event"),
                    HasSubstr("LCM's own reader returns")));
  ASSERT_EQ(Cell("log repair bad --out good").code, 0);
  const auto all = EventsOf(dir_ / "a/cell-0001.lcmlog");
  const auto saved = EventsOf(dir_ / "good");
  EXPECT_GE(saved.size() + 2, all.size());
  EXPECT_TRUE(
      std::includes(all.begin(), all.end(), saved.begin(), saved.end()));
  // Nothing is overwritten.
  const ShellResult again = Cell("log repair bad --out good");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.output, HasSubstr("good: exists"));
}

TEST_F(LogCommand, WhatIsNoLogOrAnotherProgramsIsToldApart) {
  std::ofstream(dir_ / "text") << "no log at all\n";
  EXPECT_THAT(Cell("log check text").output, HasSubstr("is not an LCM log"));
  {
    EventLogWriter writer(dir_ / "foreign");
    for (int i = 0; i < 5; ++i) writer.Write(i, "POSE", Bytes(40, 1));
    writer.Write(5, "TRACKS", Bytes(40, 2));
  }
  const ShellResult check = Cell("log check foreign");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(check.output,
              AllOf(HasSubstr("no TICK"),
                    HasSubstr("TRACKS: 1 messages have the type hash "
                              "0202020202020202; this program's tracks_t")));
  const ShellResult convert = Cell("log convert foreign --out out");
  EXPECT_EQ(convert.code, 1);
  EXPECT_THAT(convert.output, HasSubstr("no TICK"));
  EXPECT_FALSE(fs::exists(dir_ / "out"));
  EXPECT_EQ(Cell("log check nowhere").code, 2);
}

TEST_F(LogCommand, ALiveCellsLostFramesAreNamed) {
  ASSERT_EQ(Cell("prepare --cameras --state-dir .").code, 0);
  {
    EventLogWriter writer(dir_ / "runs/current/cell-0001.lcmlog");
    writer.Write(0, "STEP", Bus::Encode(step_t{}));
    for (const int32_t seq : {0, 2}) {
      Bytes frame(kWireHeaderEnd);
      WriteIdentity(seq, 12, seq, frame);
      writer.Write(seq, "FRAME_2", frame);
    }
  }
  const ShellResult check = Cell("log check runs/current");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(
      check.output,
      HasSubstr("the log lacks FRAME_2 sender 12 (camera_set@2) seq 1\n"));
}

}  // namespace
}  // namespace cell
