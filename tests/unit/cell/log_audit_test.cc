// Damaged, truncated, stock and foreign logs of a toy cell.
#include "services/cell/logs/log_audit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <set>

#include "cell/ack_t.hpp"
#include "common/bus/manifest.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "services/cell/logs/canonical_log.h"
#include "services/cell/logs/channel_types.h"
#include "services/cell/logs/stock_reader.h"
#include "services/recorder/recorder.h"
#include "tests/test_folder.h"
#include "tests/unit/toy_services.h"

namespace cell {

using namespace recorder;

using namespace cli;
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ResultOf;

std::vector<std::string> Texts(const LogAudit& audit) {
  std::vector<std::string> texts;
  for (const LogFinding& f : audit.findings) texts.push_back(ToString(f));
  return texts;
}

std::string ContentsOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Events of a log with what stands in their frames.
using Event = std::tuple<int64_t, std::string, Bytes>;
std::vector<Event> EventsOf(const fs::path& path) {
  EventLogReader reader(path);
  reader.Finish();
  std::vector<Event> events;
  while (const auto event = reader.Next()) {
    events.emplace_back(event->utime, event->channel, event->bytes);
  }
  return events;
}

size_t NumIn(const std::vector<Event>& events, const std::vector<Event>& all) {
  const std::multiset<Event> set(all.begin(), all.end());
  return static_cast<size_t>(
      std::count_if(events.begin(), events.end(),
                    [&](const Event& event) { return set.contains(event); }));
}

class LogAuditTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = NewTestFolder();
    Record();
  }
  void TearDown() override {
    if (!HasFailure()) fs::remove_all(dir_);
  }

  // A run with a death in it, as the cell's recorder keeps it; beside it what
  // went over the bus.
  void Record() {
    Roster roster = toy::ToyRoster();
    roster.entries.push_back({"recorder", 1, "recorder"});
    auto factories = toy::ToyFactories(kNumTicks);
    factories["recorder"] = [this](Bus& bus) {
      return std::make_unique<Recorder>(bus, dir_);
    };
    SimBus bus(roster, factories, {{"first", 20, 21}});
    while (bus.Step()) {
      tick_t tick = bus.last_tick();
      tick.run = 4711;
      for (joined_t& joined : tick.joined) joined.nonce = 99;
      for (const Message& message : bus.last_messages()) {
        heard_.push_back(message);
      }
      Bytes bytes = Bus::Encode(tick);
      heard_.push_back(*MessageFromWire(kTickChannel, std::move(bytes)));
    }
  }
  fs::path Log() const { return dir_ / "cell-0001.lcmlog"; }
  fs::path Damaged() const { return dir_ / "damaged"; }
  LogAudit AuditOf(const fs::path& path) const {
    return AuditLog(ReadLogIndex({path}));
  }
  LogAudit AuditOfBytes(const std::string& bytes) const {
    std::ofstream(Damaged(), std::ios::binary) << bytes;
    return AuditOf(Damaged());
  }
  std::vector<Event> Repaired() const {
    const fs::path out = dir_ / "repaired";
    fs::remove(out);
    const LogIndex index = ReadLogIndex({Damaged()});
    WriteCanonicalLog(index, AuditLog(index), out);
    return EventsOf(out);
  }
  // As lcm-logger would have written the messages that came.
  void WriteStock(const fs::path& path,
                  const std::function<bool(const Message&)>& is_lost) const {
    EventLogWriter writer(path);
    int64_t wall_us = 1'700'000'000'000'000;
    writer.Write(wall_us, "LCM_SELF_TEST", Bytes(12, 'x'));
    for (const Message& m : heard_) {
      wall_us += 431;
      if (is_lost(m)) continue;
      writer.Write(wall_us, m.channel, *m.bytes);
      // TICKs are repeated; a service that dies may have said something else.
      if (m.channel == kTickChannel && m.tick % 7 == 0) {
        writer.Write(wall_us, m.channel, *m.bytes);
      }
      if (m.channel == "DOUBLE" && m.tick == 19) {
        writer.Write(wall_us, m.channel,
                     Bus::Encode(toy::Number(m.tick * kTickUs, 1)));
        writer.Write(wall_us, kAckChannel, Bus::Encode(ack_t{}));
      }
    }
  }

  // Converts a stock recording without the messages of `heard_` for which
  // `is_lost`, by index.
  LogAudit ConvertWithout(const std::function<bool(size_t)>& is_lost) const {
    size_t i = 0;
    WriteStock(dir_ / "stock", [&](const Message&) { return is_lost(i++); });
    fs::remove(dir_ / "converted");
    const LogIndex index = ReadLogIndex({dir_ / "stock"});
    const LogAudit audit = AuditLog(index);
    WriteCanonicalLog(index, audit, dir_ / "converted");
    return audit;
  }
  // Whether any other message of the same channel and sender is kept.
  static bool IsHeardElsewhere(const Message& m,
                               const std::vector<Event>& kept) {
    return std::any_of(kept.begin(), kept.end(), [&](const Event& event) {
      const auto& [utime, channel, bytes] = event;
      return channel == m.channel && ReadWireHeader(bytes).sender == m.sender;
    });
  }
  // Messages of the run that are neither in `kept` nor in a finding.
  std::vector<std::string> UntoldLosses(const std::vector<Event>& kept,
                                        const LogAudit& audit) const {
    const std::multiset<Event> set(kept.begin(), kept.end());
    const std::vector<std::string> texts = Texts(audit);
    const auto is_told = [&](const std::string& text) {
      return std::any_of(texts.begin(), texts.end(), [&](const auto& finding) {
        return finding.find(text) != std::string::npos;
      });
    };
    std::vector<std::string> untold;
    for (const Event& event : EventsOf(Log())) {
      if (set.contains(event)) continue;
      const auto& [utime, channel, bytes] = event;
      const auto m = MessageFromWire(channel, bytes);
      const std::string sender = " sender " + std::to_string(m->sender);
      const std::string id =
          channel + ":" + sender + " seq " + std::to_string(m->seq);
      bool is_known =
          channel == kTickChannel
              ? is_told("tick " + std::to_string(m->tick) + ": TICK: is lost")
              : is_told(id + " is lost") || is_told(id + ", which");
      for (int32_t tick = m->tick; tick <= kNumTicks + 2; ++tick) {
        is_known |= is_told("log begins with tick " + std::to_string(tick + 1));
      }
      for (int32_t tick = 0; tick <= m->tick; ++tick) {
        is_known |= is_told("tick " + std::to_string(tick) + ": the log ends");
      }
      // By the last one that is known, or the first.
      const std::string flow = channel + sender + " seq ";
      for (int32_t seq = 0; seq < m->seq; ++seq) {
        is_known |= is_told(flow + std::to_string(seq) + ",");
      }
      for (int32_t seq = m->seq + 1; seq < m->seq + 30; ++seq) {
        is_known |= is_told("none is known before: ") &&
                    is_told(flow + std::to_string(seq));
      }
      is_known |=
          is_told("or any sender on a channel where it sent nothing else") &&
          !IsHeardElsewhere(*m, kept);
      if (!is_known) untold.push_back(id);
    }
    return untold;
  }

  static constexpr int32_t kNumTicks = 60;
  fs::path dir_;
  std::vector<Message> heard_;
};

TEST_F(LogAuditTest, AWholeLogIsWhole) {
  const LogAudit audit = AuditOf(Log());
  EXPECT_TRUE(audit.is_canonical);
  EXPECT_THAT(Texts(audit), IsEmpty());
  EXPECT_EQ(audit.manifests.size(), size_t{kNumTicks} + 2);
  fs::copy(Log(), Damaged());
  EXPECT_EQ(Repaired(), EventsOf(Log()));
}

TEST_F(LogAuditTest, OneByteFlippedOrRemovedCostsAtMostOneEventAndIsReported) {
  const std::string whole = ContentsOf(Log());
  const std::vector<Event> events = EventsOf(Log());
  std::mt19937 random(5);
  constexpr int kNumPlaces = 1000;
  int64_t num_stock = 0, num_short = 0, num_killed = 0, num_own = 0;
  for (int i = 0; i < kNumPlaces; ++i) {
    std::string bytes = whole;
    const size_t place = random() % bytes.size();
    const bool is_flip = random() % 2 == 0;
    if (is_flip) {
      bytes[place] = static_cast<char>(bytes[place] ^ (1 + random() % 255));
    } else {
      bytes.erase(place, 1);
    }
    SCOPED_TRACE((is_flip ? "flipped byte " : "removed byte ") +
                 std::to_string(place));
    EXPECT_FALSE(AuditOfBytes(bytes).findings.empty());
    const std::vector<Event> repaired = Repaired();
    EXPECT_GE(repaired.size(), events.size() - 1);
    EXPECT_EQ(NumIn(repaired, events), repaired.size())
        << "one is made up: "
        << testing::PrintToString(Texts(AuditOf(Damaged())));
    const StockReading stock = ReadAsStockToolsDo(Damaged());
    num_own += static_cast<int64_t>(repaired.size());
    num_stock += stock.num_events;
    num_short += stock.num_events + 1 < static_cast<int64_t>(events.size());
    num_killed += stock.end != "says that the log ends";
  }
  const double all = static_cast<double>(events.size()) * kNumPlaces;
  std::cout << "of " << events.size() << " events, one byte damaged at "
            << kNumPlaces << " places: kept "
            << 100 * static_cast<double>(num_own) / all
            << " %; LCM's own reader returns "
            << 100 * static_cast<double>(num_stock) / all << " %, loses more "
            << "than one event " << num_short << " times without a word, dies "
            << num_killed << " times\n";
}

TEST_F(LogAuditTest, ManyCorruptBytesInOneLogCostOneEventEach) {
  const std::string whole = ContentsOf(Log());
  const std::vector<Event> events = EventsOf(Log());
  std::mt19937 random(7);
  constexpr size_t kNumCorruptBytes = 10;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE("log " + std::to_string(i));
    std::string bytes = whole;
    for (size_t j = 0; j < kNumCorruptBytes; ++j) {
      const size_t place = random() % bytes.size();
      if (random() % 2 == 0) {
        bytes[place] = static_cast<char>(bytes[place] ^ (1 + random() % 255));
      } else {
        bytes.erase(place, 1);
      }
    }
    const LogAudit audit = AuditOfBytes(bytes);
    const std::vector<Event> repaired = Repaired();
    const size_t num_true = NumIn(repaired, events);
    EXPECT_GE(num_true + kNumCorruptBytes, events.size());
    // Only what no TICK proves may be wrong.
    EXPECT_LE(static_cast<int64_t>(repaired.size() - num_true),
              audit.num_unproved);
  }
}

TEST_F(LogAuditTest, ATruncatedOneKeepsAllBeforeTheCutAndSaysThatItIsCut) {
  const std::string whole = ContentsOf(Log());
  const std::vector<Event> events = EventsOf(Log());
  const LogIndex index = ReadLogIndex({Log()});
  std::mt19937 random(6);
  for (int i = 0; i < 300; ++i) {
    // Half of them at the end of an event.
    const LogEntry& entry =
        index.entries[300 + random() % (index.entries.size() - 300)];
    const auto cut = static_cast<size_t>(
        entry.offset + (i % 2 == 0 ? 0 : random() % entry.size));
    SCOPED_TRACE("cut at byte " + std::to_string(cut));
    EXPECT_FALSE(AuditOfBytes(whole.substr(0, cut)).findings.empty());
    const auto num = std::partition_point(
        index.entries.begin(), index.entries.end(), [&](const LogEntry& e) {
          return static_cast<size_t>(e.offset + e.size) <= cut;
        });
    EXPECT_EQ(Repaired(), std::vector<Event>(
                              events.begin(),
                              events.begin() + (num - index.entries.begin())));
  }
}

TEST_F(LogAuditTest, ALostTickIsRebuiltToTheByte) {
  const LogIndex index = ReadLogIndex({Log()});
  const auto victim = std::find_if(
      index.entries.begin(), index.entries.end(), [](const LogEntry& e) {
        return e.message.channel == kTickChannel && e.message.tick == 30;
      });
  std::string bytes = ContentsOf(Log());
  bytes.erase(static_cast<size_t>(victim->offset),
              static_cast<size_t>(victim->size));
  const LogAudit audit = AuditOfBytes(bytes);
  EXPECT_THAT(Texts(audit), Contains(AllOf(HasSubstr("tick 30: TICK"),
                                           HasSubstr("reconstructed from"))));
  EXPECT_EQ(Repaired(), EventsOf(Log()));
}

TEST_F(LogAuditTest, ADamagedPayloadIsNamedWithPlaceTickChannelAndDigests) {
  const LogIndex index = ReadLogIndex({Log()});
  const auto victim = std::find_if(
      index.entries.begin(), index.entries.end(), [](const LogEntry& e) {
        return e.message.channel == "SUM" && e.message.tick > 30;
      });
  std::string bytes = ContentsOf(Log());
  bytes[static_cast<size_t>(victim->offset + victim->size - 1)] ^= 1;
  const std::vector<std::string> texts = Texts(AuditOfBytes(bytes));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_THAT(
      texts[0],
      AllOf(HasSubstr("byte " + std::to_string(victim->offset)),
            HasSubstr("tick " + std::to_string(victim->message.tick) + ": SUM"),
            HasSubstr("is damaged: its digest is")));
}

TEST_F(LogAuditTest, AStockRecordingConvertsToTheRecordersBytes) {
  const fs::path stock = dir_ / "stock";
  WriteStock(stock, [](const Message&) { return false; });
  const LogIndex index = ReadLogIndex({stock});
  const LogAudit audit = AuditLog(index);
  EXPECT_FALSE(audit.is_canonical);
  EXPECT_THAT(Texts(audit), IsEmpty());
  EXPECT_GE(audit.num_unnamed, 1);
  WriteCanonicalLog(index, audit, dir_ / "converted");
  EXPECT_EQ(ContentsOf(dir_ / "converted"), ContentsOf(Log()));
}

TEST_F(LogAuditTest, AStockRecordingThatLacksMessagesNamesThem) {
  const fs::path stock = dir_ / "stock";
  WriteStock(stock, [](const Message& m) {
    return m.channel == "ECHO" && (m.tick == 40 || m.tick == 44);
  });
  const LogIndex index = ReadLogIndex({stock});
  const LogAudit audit = AuditLog(index);
  size_t num_lost = 0;
  for (const Message& m : heard_) {
    if (m.channel != "ECHO" || (m.tick != 40 && m.tick != 44)) continue;
    ++num_lost;
    EXPECT_THAT(
        Texts(audit),
        Contains(HasSubstr("tick " + std::to_string(m.tick) +
                           ": ECHO: sender 3 seq " + std::to_string(m.seq))));
  }
  EXPECT_GE(num_lost, 1u);
  EXPECT_EQ(audit.findings.size(), num_lost);
  WriteCanonicalLog(index, audit, dir_ / "converted");
  const auto converted = EventsOf(dir_ / "converted");
  EXPECT_EQ(converted.size() + num_lost, EventsOf(Log()).size());
  EXPECT_EQ(NumIn(converted, EventsOf(Log())), converted.size());
}

TEST_F(LogAuditTest, ARunOfLostTicksIsRebuiltToTheByte) {
  for (const int32_t first : {2, 11, 27, 50}) {
    for (const int32_t length : {1, 2, 3, 9}) {
      SCOPED_TRACE(testing::Message() << length << " TICKs from " << first);
      const LogAudit audit = ConvertWithout([&](size_t i) {
        return heard_[i].channel == kTickChannel && heard_[i].tick >= first &&
               heard_[i].tick < first + length;
      });
      EXPECT_TRUE(audit.is_complete);
      EXPECT_EQ(audit.findings.size(), static_cast<size_t>(length));
      EXPECT_EQ(ContentsOf(dir_ / "converted"), ContentsOf(Log()));
    }
  }
}

TEST_F(LogAuditTest, EachMessageThatIsLostWithTheTicksThatNamedItIsNamed) {
  const size_t num_own = EventsOf(Log()).size();
  // Those of 4 ticks: their TICKs, and what a burst has taken beside them.
  const auto num_named = [](const LogAudit& audit) {
    const auto texts = Texts(audit);
    return static_cast<size_t>(
        std::count_if(texts.begin(), texts.end(), [](const auto& text) {
          return text.find("is lost") != std::string::npos;
        }));
  };
  for (const int32_t first : {5, 19, 22, 31, 48}) {
    for (const char* channel : {"", "SOURCE", "DOUBLE", "SUM"}) {
      SCOPED_TRACE(testing::Message() << channel << " from " << first);
      const LogAudit audit = ConvertWithout([&](size_t i) {
        const Message& m = heard_[i];
        const bool is_in = m.tick >= first && m.tick < first + 4;
        return is_in && (m.channel == kTickChannel || channel[0] == '\0' ||
                         m.channel == channel);
      });
      const auto converted = EventsOf(dir_ / "converted");
      EXPECT_FALSE(audit.is_complete);
      EXPECT_EQ(NumIn(converted, EventsOf(Log())), converted.size());
      EXPECT_THAT(UntoldLosses(converted, audit), IsEmpty());
      if (first != 19) {  // else one sender's last ones are among them
        EXPECT_EQ(converted.size() + num_named(audit), num_own);
      }
    }
  }
}

TEST_F(LogAuditTest, ALostBeginningOrEndIsNamed) {
  for (const int32_t num : {1, 2, 5}) {
    for (const bool is_ticks_only : {false, true}) {
      for (const bool is_end : {false, true}) {
        SCOPED_TRACE(testing::Message() << num << is_ticks_only << is_end);
        const int32_t last = heard_.back().tick;
        const LogAudit audit = ConvertWithout([&](size_t i) {
          const Message& m = heard_[i];
          return (is_end ? m.tick > last - num : m.tick < num) &&
                 (!is_ticks_only || m.channel == kTickChannel);
        });
        const auto converted = EventsOf(dir_ / "converted");
        EXPECT_FALSE(audit.is_complete);
        EXPECT_EQ(NumIn(converted, EventsOf(Log())), converted.size());
        EXPECT_THAT(UntoldLosses(converted, audit), IsEmpty());
        if (is_ticks_only && is_end) {  // what was heard is kept
          EXPECT_EQ(converted.size() + static_cast<size_t>(num),
                    EventsOf(Log()).size());
        }
      }
    }
  }
}

TEST_F(LogAuditTest, WhateverIsLostIsNamed) {
  for (int seed = 100; seed < 190; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<uint32_t>(seed));
    // Bursts, as a full receive buffer loses them, and single ones.
    size_t end_of_burst = 0;
    const LogAudit audit = ConvertWithout([&](size_t i) {
      if (random() % 50 == 0) end_of_burst = i + random() % 30;
      return i < end_of_burst || random() % 20 == 0;
    });
    const auto converted = EventsOf(dir_ / "converted");
    EXPECT_EQ(NumIn(converted, EventsOf(Log())), converted.size());
    EXPECT_THAT(UntoldLosses(converted, audit), IsEmpty())
        << testing::PrintToString(Texts(audit));
    EXPECT_FALSE(audit.is_complete);
  }
}

TEST_F(LogAuditTest, ARunOfTicksCutOutOfARecordersLogIsRebuiltOrNamed) {
  const LogIndex index = ReadLogIndex({Log()});
  const std::string whole = ContentsOf(Log());
  for (const bool is_ticks_only : {true, false}) {
    std::string bytes;
    for (const LogEntry& entry : index.entries) {
      const bool is_cut =
          entry.message.tick >= 30 && entry.message.tick < 34 &&
          (!is_ticks_only || entry.message.channel == kTickChannel);
      if (is_cut) continue;
      bytes += whole.substr(static_cast<size_t>(entry.offset),
                            static_cast<size_t>(entry.size));
    }
    const LogAudit audit = AuditOfBytes(bytes);
    EXPECT_FALSE(audit.findings.empty());
    EXPECT_EQ(audit.is_complete, is_ticks_only);
    EXPECT_THAT(UntoldLosses(Repaired(), audit), IsEmpty());
    if (is_ticks_only) {
      EXPECT_EQ(Repaired(), EventsOf(Log()));
    }
  }
}

TEST_F(LogAuditTest, AMessageWithAForgedNamesakeIsTheOneOfTheManifest) {
  const fs::path stock = dir_ / "stock";
  WriteStock(stock, [](const Message&) { return false; });
  const auto events = EventsOf(stock);
  {
    EventLogWriter writer(stock);
    for (auto [utime, channel, bytes] : events) {
      const Bytes good = bytes;
      bytes.back() ^= 1;
      if (channel == "SUM") writer.Write(utime, channel, bytes);
      writer.Write(utime, channel, good);
    }
  }
  const LogIndex index = ReadLogIndex({stock});
  const LogAudit audit = AuditLog(index);
  EXPECT_THAT(Texts(audit), IsEmpty());
  WriteCanonicalLog(index, audit, dir_ / "converted");
  EXPECT_EQ(ContentsOf(dir_ / "converted"), ContentsOf(Log()));
}

TEST_F(LogAuditTest, ALogOfOtherTypesIsReportedWithChannelAndBothHashes) {
  auto events = EventsOf(Log());
  {
    EventLogWriter writer(Damaged());
    for (auto& [utime, channel, bytes] : events) {
      if (channel == kTickChannel) bytes[7] ^= 1;
      writer.Write(utime, channel, bytes);
    }
  }
  const LogAudit audit = AuditOf(Damaged());
  EXPECT_THAT(audit.manifests, IsEmpty());
  const std::vector<std::string> texts = Texts(audit);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_THAT(texts[0], AllOf(HasSubstr("TICK: "), HasSubstr("tick_t"),
                              HasSubstr("other message types")));
  EXPECT_EQ(Repaired().size(), events.size());
}

TEST_F(LogAuditTest, AForeignLogHasNoManifestsAndIsKeptUnchanged) {
  {
    EventLogWriter writer(Damaged());
    for (int i = 0; i < 10; ++i) writer.Write(i, "POSE", Bytes(50, 7));
  }
  std::string bytes = ContentsOf(Damaged());
  bytes[bytes.size() / 2 + 40] ^= 1;
  bytes.erase(30, 1);
  const LogAudit audit = AuditOfBytes(bytes);
  EXPECT_THAT(audit.manifests, IsEmpty());
  EXPECT_THAT(Texts(audit), Contains(HasSubstr("event 0 is lost")));
  EXPECT_EQ(Repaired().size(), 9u);
}

// The bytes of an event with this number.
std::string Framed(int64_t number, int64_t utime, const std::string& channel,
                   const std::string& bytes) {
  std::string text;
  const auto put = [&text](uint64_t value, int num_bytes) {
    for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
      text += static_cast<char>(value >> shift);
    }
  };
  put(0xEDA1DA01, 4);
  put(static_cast<uint64_t>(number), 8);
  put(static_cast<uint64_t>(utime), 8);
  put(channel.size(), 4);
  put(bytes.size(), 4);
  return text + channel + bytes;
}

TEST_F(LogAuditTest, AnInsertedEventIsOneFinding) {
  const std::string good = ContentsOf(Log());
  EventLogReader reader(Log());
  reader.Finish();
  int64_t middle = 0;
  int64_t number = 0;
  while (const auto event = reader.Next()) {
    if (event->number > 100) break;
    middle = event->offset;
    number = event->number;
  }
  for (const int64_t own : {number, int64_t{0}, int64_t{-5}, number + 50}) {
    const std::string foreign =
        Framed(own, 5, "FOREIGN", std::string(40, '\0'));
    const auto at = static_cast<size_t>(middle);
    EXPECT_THAT(
        Texts(AuditOfBytes(good.substr(0, at) + foreign + good.substr(at))),
        testing::ElementsAre(
            AllOf(HasSubstr("damaged byte " + std::to_string(middle) + " (75"),
                  HasSubstr("FOREIGN: "), HasSubstr("no TICK names it"))))
        << own;
    EXPECT_EQ(Texts(AuditOfBytes(good + foreign)).size(), 1u) << own;
  }
}

TEST_F(LogAuditTest, AWholeLogBehindAnotherIsOneFinding) {
  const std::string good = ContentsOf(Log());
  const auto texts = Texts(AuditOfBytes(good + good));
  ASSERT_EQ(texts.size(), 1u) << texts[1];
  EXPECT_THAT(texts[0], AllOf(HasSubstr("its number is 0, should be "),
                              HasSubstr("events after it, up to byte " +
                                        std::to_string(2 * good.size()))));
}

TEST_F(LogAuditTest, NumbersThatRestartAfterACorruptRangeAreNoLoss) {
  const auto texts = Texts(
      AuditOfBytes(ContentsOf(Log()) + "garbage" + Framed(0, 5, "A", "b")));
  EXPECT_THAT(texts, Contains(HasSubstr("the numbers restart at 0")));
  EXPECT_THAT(texts, testing::Each(testing::Not(HasSubstr(" to -1 "))));
}

// Events of another program, by their stamps [us] and numbers.
class ForeignLog : public LogAuditTest {
 protected:
  std::vector<std::string> TextsOf(
      const std::function<int64_t(int)>& utime_of,
      const std::function<int(int)>& number_of = [](int i) { return i; }) {
    std::string bytes;
    for (int i = 0; i < 200; ++i) {
      bytes += Framed(number_of(i), utime_of(i), "POSE", std::string(40, 'x'));
    }
    return Texts(AuditOfBytes(bytes));
  }
};

TEST_F(ForeignLog, ReportsWhereTimeRunsBack) {
  EXPECT_THAT(TextsOf([](int i) { return i * 8000; }), IsEmpty());
  EXPECT_THAT(
      TextsOf([](int i) { return i * 8000 - (i >= 100 ? 250'000 : 0); }),
      testing::ElementsAre(AllOf(
          HasSubstr("damaged byte 7200 (72 bytes): POSE: "),
          HasSubstr(
              "time runs backwards: it is 0.242000 s earlier than the "))));
}

TEST_F(ForeignLog, ReportsWhereItPausesForLong) {
  EXPECT_THAT(
      TextsOf([](int i) { return i * 8000 + (i >= 100 ? 60'000'000 : 0); }),
      testing::ElementsAre(
          AllOf(HasSubstr("damaged byte 7200 "),
                HasSubstr("no event for 60.008 s before it"))));
  // A log of a few messages with pauses between is not reported.
  EXPECT_THAT(TextsOf([](int i) { return i * 8000 + i / 10 * 5'000'000; }),
              IsEmpty());
}

TEST_F(ForeignLog, ReportsWhereNumbersAreMissingOrThatThereAreNone) {
  const auto utime_of = [](int i) {
    return i * 8000;
  };
  EXPECT_THAT(TextsOf(utime_of, [](int i) { return i < 100 ? i : i + 7; }),
              testing::ElementsAre(
                  HasSubstr("its number is 107, should be 100: the events")));
  EXPECT_THAT(
      TextsOf(utime_of, [](int) { return 0; }),
      testing::ElementsAre(HasSubstr("198 other numbers jump as well")));
}

TEST_F(LogAuditTest, PartsOfLcmLoggerAreReadInTheOrderOfTheirNumbers) {
  const fs::path folder = dir_ / "parts";
  fs::create_directories(folder);
  std::vector<fs::path> expected;
  const auto events = EventsOf(Log());
  constexpr size_t kNumParts = 101;
  for (size_t part = 0; part < kNumParts; ++part) {
    expected.push_back(folder / fmt::format("rec.{:02}", part));
    EventLogWriter writer(expected.back());
    for (size_t i = part * events.size() / kNumParts;
         i < (part + 1) * events.size() / kNumParts; ++i) {
      const auto& [utime, channel, bytes] = events[i];
      writer.Write(utime, channel, bytes);
    }
  }
  std::ofstream(folder / "notes.txt") << "none";
  EXPECT_EQ(RequireLogsOf(folder), expected);
  EXPECT_THAT(Texts(AuditLog(ReadLogIndex(RequireLogsOf(folder)))), IsEmpty());
  EXPECT_THAT(RunLog::Load(folder).problems(), IsEmpty());
  std::ofstream(folder / "other.00") << "x";
  EXPECT_THROW(RequireLogsOf(folder), std::runtime_error);
}

TEST_F(LogAuditTest, AFileThatIsNoLogIsReportedAsSuch) {
  EXPECT_THROW(AuditOfBytes(""), std::runtime_error);
  EXPECT_THROW(AuditOfBytes(std::string(3000, 'x')), std::runtime_error);
}

TEST(ChannelTypes, AreThoseOfTheTableOfChannels) {
  std::ifstream table(fs::path(CELL_SOURCE_DIR) / "lcmtypes" / "README.md");
  std::string line;
  size_t num = 0;
  while (std::getline(table, line)) {
    // | NAME, NAME | type_t | ...
    const size_t end_of_names = line.find(" | ");
    if (!line.starts_with("| ") || end_of_names == std::string::npos) continue;
    const size_t begin = end_of_names + 3;
    const std::string type = line.substr(begin, line.find(" |", begin) - begin);
    if (!type.ends_with("_t")) continue;
    std::string names = line.substr(2, end_of_names - 2) + ", ";
    for (size_t comma = 0; (comma = names.find(", ")) != std::string::npos;
         names.erase(0, comma + 2)) {
      const std::string name = names.substr(0, comma);
      const auto known = TypeOfChannel(name);
      ASSERT_TRUE(known) << name;
      EXPECT_EQ(known->name, type) << name;
      ++num;
    }
  }
  EXPECT_GE(num, 30u);
  EXPECT_FALSE(TypeOfChannel("LCM_SELF_TEST"));
}

}  // namespace
}  // namespace cell
