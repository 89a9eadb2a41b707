#include "common/bus/event_log.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <lcm/lcm-cpp.hpp>
#include <random>

#include "common/bus/manifest.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "tests/test_folder.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

class EventLog : public testing::Test {
 protected:
  void SetUp() override { dir_ = NewTestFolder(); }
  std::filesystem::path Path() const { return dir_ / "cell.lcmlog"; }
  std::vector<std::string> ReadChannels() {
    EventLogReader reader(Path());
    reader.Finish();
    std::vector<std::string> channels;
    while (const auto event = reader.Next()) channels.push_back(event->channel);
    num_corrupt_ranges_ = reader.corrupt_ranges().size();
    return channels;
  }
  void Write(int num_events) {
    EventLogWriter writer(Path());
    for (int i = 0; i < num_events; ++i) {
      writer.Write(i, "C" + std::to_string(i), Bytes(40, uint8_t(i)));
    }
  }
  std::string Contents() {
    std::ifstream in(Path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void Overwrite(const std::string& contents) {
    std::ofstream(Path(), std::ios::binary) << contents;
  }

  std::filesystem::path dir_;
  size_t num_corrupt_ranges_ = 0;
};

TEST_F(EventLog, IsReadableByLcmAndByItself) {
  Write(3);
  EXPECT_THAT(ReadChannels(), testing::ElementsAre("C0", "C1", "C2"));
  EXPECT_EQ(num_corrupt_ranges_, 0u);
  lcm::LogFile stock(Path().string(), "r");
  ASSERT_TRUE(stock.good());
  const lcm::LogEvent* event = stock.readNextEvent();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->channel, "C0");
  EXPECT_EQ(event->datalen, 40);
}

TEST_F(EventLog, AnyFlippedOrRemovedByteCostsAtMostOneEvent) {
  Write(5);
  const std::string whole = Contents();
  for (size_t i = 0; i < whole.size(); ++i) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
    Overwrite(flipped);
    EXPECT_GE(ReadChannels().size(), 4u) << "byte " << i << " flipped";
    std::string removed = whole;
    removed.erase(i, 1);
    Overwrite(removed);
    EXPECT_GE(ReadChannels().size(), 4u) << "byte " << i << " removed";
    EXPECT_GE(num_corrupt_ranges_, 1u) << "byte " << i << " removed";
  }
}

TEST_F(EventLog, ALengthThatSwallowsItsNeighbourToTheByteCostsOneEvent) {
  Write(5);
  std::string bytes = Contents();
  const size_t event_size = bytes.size() / 5;
  // The second one claims to end where the third one does.
  char& low_byte = bytes[event_size + 27];
  low_byte = static_cast<char>(static_cast<size_t>(low_byte) + event_size);
  Overwrite(bytes);
  EXPECT_THAT(ReadChannels(), testing::ElementsAre("C0", "C2", "C3", "C4"));
  EXPECT_EQ(num_corrupt_ranges_, 1u);
}

TEST_F(EventLog, ASyncWordWithinAMessageIsNoDamage) {
  {
    EventLogWriter writer(Path());
    Bytes bytes(60, 0);
    const Bytes sync = {0xED, 0xA1, 0xDA, 0x01};
    std::copy(sync.begin(), sync.end(), bytes.begin() + 10);
    for (const char* channel : {"A", "B", "C"}) {
      writer.Write(0, channel, bytes);
    }
  }
  EXPECT_EQ(ReadChannels().size(), 3u);
  EXPECT_EQ(num_corrupt_ranges_, 0u);
}

TEST_F(EventLog, WhatLcmReadsIsReadHoweverLong) {
  const std::string long_name(999, 'c');
  {
    EventLogWriter writer(Path());
    writer.Write(0, "A", Bytes(40, 0));
    writer.Write(1, "B", Bytes(size_t{20} << 20, 1));
    writer.Write(2, long_name, Bytes(40, 2));
    writer.Write(3, "D", Bytes(size_t{20} << 20, 3));
  }
  EXPECT_THAT(ReadChannels(), testing::ElementsAre("A", "B", long_name, "D"));
  EXPECT_EQ(num_corrupt_ranges_, 0u);
  lcm::LogFile stock(Path().string(), "r");
  int num_stock = 0;
  while (stock.readNextEvent() != nullptr) ++num_stock;
  EXPECT_EQ(num_stock, 4);
}

TEST_F(EventLog, ALengthThatIsMuchTooLongCostsOneEvent) {
  Write(5);
  const std::string whole = Contents();
  const size_t event_size = whole.size() / 5;
  // Far beyond the end of the file, and within it.
  for (const auto& [byte, value] : {std::pair{24, 0x7F}, {24, 1}, {25, 0x20}}) {
    std::string bytes = whole + std::string(size_t{3} << 20, '\0');
    bytes[event_size + static_cast<size_t>(byte)] = static_cast<char>(value);
    Overwrite(bytes);
    EXPECT_THAT(ReadChannels(), testing::ElementsAre("C0", "C2", "C3", "C4"));
  }
}

TEST_F(EventLog, AnEventThatNoLogCanHoldIsRefusedWithItsLengths) {
  EventLogWriter writer(Path());
  for (const std::string& channel : {std::string(), std::string(1000, 'c')}) {
    try {
      writer.Write(0, channel, Bytes(40, 0));
      ADD_FAILURE() << channel.size() << " characters were written";
    } catch (const std::runtime_error& e) {
      EXPECT_THAT(
          e.what(),
          testing::AllOf(testing::HasSubstr("cell.lcmlog"),
                         testing::HasSubstr(std::to_string(channel.size()) +
                                            " characters")));
    }
  }
  writer.Write(1, "A", Bytes(40, 0));
  writer.Flush();
  EXPECT_THAT(ReadChannels(), testing::ElementsAre("A"));
}

TEST_F(EventLog, ATruncatedOneKeepsAllBeforeTheCut) {
  Write(5);
  const std::string whole = Contents();
  const size_t event_size = whole.size() / 5;
  for (size_t size = 0; size < whole.size(); ++size) {
    Overwrite(whole.substr(0, size));
    EXPECT_EQ(ReadChannels().size(), size / event_size) << size << " bytes";
    EXPECT_EQ(num_corrupt_ranges_, size % event_size == 0 ? 0u : 1u);
  }
}

TEST_F(EventLog, AGrowingOneGivesEachEventOnce) {
  EventLogWriter writer(Path());
  EventLogReader reader(Path());
  EXPECT_FALSE(reader.Next());
  for (int i = 0; i < 3; ++i) {
    writer.Write(i, "A", Bytes(10, 0));
    writer.Flush();
    ASSERT_TRUE(reader.Next());
    EXPECT_FALSE(reader.Next());
  }
  EXPECT_TRUE(reader.corrupt_ranges().empty());
}

// A toy cell's run as the recorder writes it: by tick, in canonical order.
void Record(const std::filesystem::path& path) {
  SimBus bus(toy::ToyRoster(), toy::ToyFactories(40), {{"first", 20, 21}});
  EventLogWriter writer(path);
  std::vector<Message> all;
  while (bus.Step()) {
    all.push_back(TickMessage(bus.last_tick()));
    for (const Message& message : bus.last_messages()) all.push_back(message);
  }
  std::sort(all.begin(), all.end(), OrderedBefore);
  for (const Message& m : all) {
    writer.Write(m.tick * kTickUs, m.channel, *m.bytes);
  }
}

TEST_F(EventLog, ARunReplaysByteForByteThroughARestart) {
  Record(Path());
  const RunLog log = RunLog::Load(dir_);
  EXPECT_THAT(log.problems(), testing::IsEmpty());
  for (const auto& [name, factory] : toy::ToyFactories(40)) {
    const ReplayResult result = Replay(log, toy::ToyRoster(), name, factory);
    EXPECT_EQ(result.difference, std::nullopt) << name;
    EXPECT_GT(result.num_messages, 8) << name;
  }
}

TEST_F(EventLog, APlantedDifferenceIsFoundWithTickAndChannel) {
  Record(Path());
  const RunLog log = RunLog::Load(dir_);
  auto factories = toy::ToyFactories(40);
  const ReplayResult result =
      Replay(log, toy::ToyRoster(), "first", [](Bus& bus) {
        return std::make_unique<toy::Adder>(bus, "SOURCE", "TRIPLE");
      });
  ASSERT_TRUE(result.difference);
  EXPECT_THAT(*result.difference, testing::AllOf(testing::HasSubstr("tick "),
                                                 testing::HasSubstr("DOUBLE")));
}

TEST_F(EventLog, ADamagedRunNamesTheMessageThatIsGone) {
  Record(Path());
  std::vector<LogEvent> events;
  {
    EventLogReader reader(Path());
    while (auto event = reader.Next()) events.push_back(*event);
  }
  const auto victim =
      std::find_if(events.begin() + 100, events.end(),
                   [](const LogEvent& e) { return e.channel == "SUM"; });
  victim->bytes.back() ^= 1;
  {
    EventLogWriter writer(Path());
    for (const LogEvent& e : events) writer.Write(e.utime, e.channel, e.bytes);
  }
  const RunLog log = RunLog::Load(dir_);
  ASSERT_EQ(log.problems().size(), 1u);
  EXPECT_THAT(log.problems()[0], testing::HasSubstr("SUM sender 2"));
}

TEST_F(EventLog, AMissingFolderIsNamed) {
  EXPECT_THROW(RunLog::Load(dir_ / "nowhere"), std::runtime_error);
  EXPECT_THROW(EventLogReader(dir_ / "none.lcmlog"), std::runtime_error);
}

}  // namespace
}  // namespace cell
