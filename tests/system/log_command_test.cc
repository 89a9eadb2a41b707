// cell log on what users have: recordings of lcm-logger, broken files.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>

#include "cell/step_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/event_log.h"
#include "common/bus/manifest.h"
#include "common/bus/message.h"
#include "common/bus/roster.h"
#include "common/config/config.h"
#include "tests/system/run_cell.h"
#include "tests/system/stock_logger.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

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

  // Whether the output of `cell log` accounts for an event: by its name, as one
  // before or after all that was recorded, or as one of lost TICKs that nothing
  // on its channel follows.
  static bool IsTold(const Event& event, const std::string& output) {
    const auto& [utime, channel, bytes] = event;
    const auto m = MessageFromWire(channel, bytes);
    const std::string sender = fmt::format("sender {} seq ", m->sender);
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
      int tick = 0;
      if (std::sscanf(line.c_str(), "tick 0: the log begins with tick %d",
                      &tick) == 1 &&
          m->tick < tick) {
        return true;
      }
      if (line.find("the log ends before") != std::string::npos &&
          std::sscanf(line.c_str(), "tick %d:", &tick) == 1 &&
          m->tick >= tick) {
        return true;
      }
      if (line.starts_with(fmt::format("tick {}: TICK: is lost", m->tick)) &&
          channel == kTickChannel) {
        return true;
      }
      const std::string id = fmt::format("{}: {}{}", channel, sender, m->seq);
      if (line.find(id + " is lost") != std::string::npos ||
          line.find(id + ", which") != std::string::npos) {
        return true;
      }
      const std::string end = fmt::format(" {} {}", channel, sender);
      const size_t place = line.find("None follows: ") == std::string::npos
                               ? std::string::npos
                               : line.find(end);
      if (place != std::string::npos &&
          std::atoi(line.c_str() + place + end.size()) < m->seq) {
        return true;
      }
    }
    return false;
  }

  static bool IsOfSameFlow(const Event& a, const Event& b) {
    return std::get<1>(a) == std::get<1>(b) &&
           ReadWireHeader(std::get<2>(a)).sender ==
               ReadWireHeader(std::get<2>(b)).sender;
  }

  // A run folder with a log of these TICKs of a run of 6, which name nothing.
  void WriteTicks(const char* run, const std::vector<int32_t>& left) const {
    fs::create_directories(dir_ / run);
    EventLogWriter writer(dir_ / run / "cell-0001.lcmlog");
    int64_t digest = 0;
    for (int32_t k = 0; k < 6; ++k) {
      tick_t tick{};
      tick.header.utime = int64_t{k} * kTickUs;
      tick.header.tick = tick.header.seq = k;
      tick.previous_digest = digest;
      tick.is_last = k == 5;
      const Message message = TickMessage(tick);
      digest = message.digest;
      if (std::find(left.begin(), left.end(), k) == left.end()) continue;
      writer.Write(tick.header.utime, message.channel, *message.bytes);
    }
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
  // At full speed lcm-logger may lose some, the more the busier the machine.
  std::vector<std::string> untold;
  size_t num_lost = 0;
  for (const Event& event : own) {
    if (converted.contains(event)) continue;
    ++num_lost;
    const bool is_only_one = std::none_of(
        converted.begin(), converted.end(),
        [&](const Event& other) { return IsOfSameFlow(event, other); });
    const bool is_told =
        IsTold(event, convert.output) ||
        (is_only_one && convert.output.find("or any sender on a channel") !=
                            std::string::npos);
    if (!is_told) untold.push_back(std::get<1>(event));
  }
  EXPECT_THAT(untold, IsEmpty()) << convert.output;
  EXPECT_EQ(convert.code, num_lost == 0 ? 0 : 1) << convert.output;
  EXPECT_EQ(convert.output.find("NOT COMPLETE") == std::string::npos,
            num_lost == 0);
  std::cout << own.size() << " messages, lcm-logger lost " << num_lost << "\n";
}

TEST_F(LogCommand, WhatLcmReadsOfAnotherProgramsLogIsWholeAndKept) {
  {
    EventLogWriter writer(dir_ / "foreign");
    writer.Write(0, "POSE", Bytes(40, 1));
    writer.Write(1, "MAP", Bytes(size_t{20} << 20, 2));
    writer.Write(2, std::string(300, 'n'), Bytes(40, 3));
    writer.Write(3, "POSE", Bytes());
  }
  const ShellResult check = Cell("log check foreign --stock");
  EXPECT_EQ(check.code, 0) << check.output;
  EXPECT_THAT(check.output,
              AllOf(HasSubstr("foreign: 4 events"), HasSubstr("\nwhole\n"),
                    HasSubstr("own reader returns 4 events")));
  EXPECT_EQ(Cell("log repair foreign --out kept").code, 0);
  EXPECT_EQ(TextOf(dir_ / "kept"), TextOf(dir_ / "foreign"));
}

TEST_F(LogCommand, DiffDoesNotCallDamagedLogsTheSame) {
  WriteTicks("a", {0, 1, 2, 3, 4, 5});
  WriteTicks("b", {0, 1, 2, 3, 4, 5});
  const ShellResult whole = Cell("diff a b");
  EXPECT_EQ(whole.code, 0) << whole.output;
  EXPECT_THAT(whole.output, HasSubstr("6 ticks, all the same"));
  for (const std::vector<int32_t>& left :
       {std::vector<int32_t>{0, 1, 4, 5}, {3, 4, 5}}) {
    fs::remove_all(dir_ / "c");
    fs::remove_all(dir_ / "d");
    WriteTicks("c", left);
    WriteTicks("d", left);
    const ShellResult both = Cell("diff c d");
    EXPECT_EQ(both.code, 1) << both.output;
    EXPECT_THAT(both.output,
                AllOf(HasSubstr("c: ticks "), HasSubstr("d: ticks "),
                      HasSubstr("both logs are damaged"),
                      Not(HasSubstr("all the same"))));
  }
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
  // A burst of datagrams that were lost, or only the TICKs of it.
  for (const bool is_ticks_only : {true, false}) {
    {
      EventLogReader reader(dir_ / "a/cell-0001.lcmlog");
      reader.Finish();
      EventLogWriter writer(dir_ / "burst");
      while (const auto event = reader.Next()) {
        const int32_t tick = ReadWireHeader(event->bytes).tick;
        if (tick >= 924 && tick <= 927 &&
            (!is_ticks_only || event->channel == kTickChannel)) {
          continue;
        }
        writer.Write(event->utime, event->channel, event->bytes);
      }
    }
    fs::remove(dir_ / "kept");
    const ShellResult repair = Cell("log repair burst --out kept");
    const auto kept = EventsOf(dir_ / "kept");
    size_t num_untold = 0;
    for (const Event& event : all) {
      num_untold += !kept.contains(event) && !IsTold(event, repair.output);
    }
    EXPECT_EQ(num_untold, 0u) << repair.output;
    EXPECT_TRUE(!is_ticks_only || kept == all);
  }
  // Nothing is overwritten.
  const ShellResult again = Cell("log repair bad --out good");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.output, HasSubstr("good: exists"));
}

TEST_F(LogCommand, FilesThatAreNoLogAndLogsOfOthersAreDistinguished) {
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
              AllOf(HasSubstr("none of them a TICK"),
                    HasSubstr("TRACKS: 1 messages have the type hash "
                              "0202020202020202; this program's tracks_t")));
  const ShellResult convert = Cell("log convert foreign --out out");
  EXPECT_EQ(convert.code, 1);
  EXPECT_THAT(convert.output, HasSubstr("none of them a TICK"));
  EXPECT_FALSE(fs::exists(dir_ / "out"));
  EXPECT_EQ(Cell("log check nowhere").code, 2);
}

TEST_F(LogCommand, AFolderOfLcmLoggersPartsIsCheckedAndReplayed) {
  ASSERT_EQ(Cell("sim --seed 3 --demonstration two_pegs --out a").code, 0);
  fs::create_directories(dir_ / "parts");
  const auto size = fs::file_size(dir_ / "a/cell-0001.lcmlog");
  {
    EventLogReader reader(dir_ / "a/cell-0001.lcmlog");
    reader.Finish();
    std::optional<EventLogWriter> writer;
    for (int part = 0; const auto event = reader.Next();) {
      if (event->offset * 3 >= static_cast<int64_t>(size) * part) {
        writer.emplace(dir_ / "parts" / ("rec.0" + std::to_string(part++)));
      }
      writer->Write(event->utime, event->channel, event->bytes);
    }
  }
  const ShellResult check = Cell("log check parts");
  EXPECT_EQ(check.code, 0) << check.output;
  EXPECT_THAT(check.output, HasSubstr("\nwhole\n"));
  const ShellResult told = Cell("replay parts");
  EXPECT_EQ(told.code, 0) << told.output;
  EXPECT_EQ(told.output, Cell("replay a").output);
  EXPECT_THAT(Cell("replay parts --check").output, HasSubstr("lacks run.yaml"));
  // Beside the configuration of the run they are recomputed.
  fs::copy(dir_ / "a", dir_ / "parts",
           fs::copy_options::recursive | fs::copy_options::skip_existing);
  fs::remove(dir_ / "parts/cell-0001.lcmlog");
  const ShellResult again = Cell("replay parts --check");
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_THAT(Cell("log check .").output, HasSubstr("NAME.00, NAME.01"));
}

TEST_F(LogCommand, ALiveCellsLostFramesAreNamed) {
  ASSERT_EQ(Cell("prepare --cameras --state-dir .").code, 0);
  const Roster roster = Roster::FromConfig(
      Config::Load(dir_ / "runs/current/deploy/config/roster.yaml"));
  const auto sender =
      static_cast<int32_t>(roster.RequireIndexOf("camera_set@2"));
  {
    EventLogWriter writer(dir_ / "runs/current/cell-0001.lcmlog");
    writer.Write(0, "STEP", Bus::Encode(step_t{}));
    for (const int32_t seq : {0, 2}) {
      Bytes frame(kWireHeaderEnd);
      WriteIdentity(seq, sender, seq, frame);
      writer.Write(seq, "FRAME_2", frame);
    }
  }
  const ShellResult check = Cell("log check runs/current");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(check.output,
              HasSubstr("the log lacks FRAME_2 sender " +
                        std::to_string(sender) + " (camera_set@2) seq 1\n"));
}

}  // namespace
}  // namespace cell
