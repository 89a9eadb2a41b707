// Live services on a wire in memory that delays, loses, doubles and shuffles:
// their journal makes each of them replay byte for byte.
#include <gmock/gmock.h>

#include <filesystem>
#include <random>

#include "cell/step_t.hpp"
#include "common/bus/event_log.h"
#include "common/bus/live_log.h"
#include "common/bus/live_node.h"
#include "common/bus/live_replay.h"
#include "common/bus/run_log.h"
#include "tests/test_folder.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using toy::ToyFactories;
using toy::ToyRoster;

constexpr int32_t kNumLiveTicks = 400;
constexpr int32_t kForever = 1 << 20;

struct WireFaults {
  double lost = 0;
  double doubled = 0;
  double slow = 0;     // a message needs up to 3 ticks more
  double skipped = 0;  // a service misses a tick
};

class LiveTest : public testing::Test {
 protected:
  ~LiveTest() override { std::filesystem::remove_all(dir_); }

  // Runs the toy cell; "second" dies at `death` and starts again.
  void Run(uint64_t seed, const WireFaults& faults, int32_t death = kForever) {
    std::mt19937_64 random(seed);
    const auto chance = [&](double p) {
      return std::uniform_real_distribution<>(0, 1)(random) < p;
    };
    EventLogWriter log(dir_ / "cell-0001.lcmlog");
    const Roster roster = ToyRoster();
    const auto factories = ToyFactories(kForever);
    std::vector<std::pair<int32_t, Message>> wire;  // due tick
    int32_t tick = 0;
    const auto send = [&](const Message& message) {
      log.Write(message.tick, message.channel, *message.bytes);
      if (chance(faults.lost)) return;
      const int32_t due =
          tick + (chance(faults.slow) ? static_cast<int32_t>(random() % 4) : 0);
      wire.emplace_back(due, message);
      if (chance(faults.doubled)) wire.emplace_back(due + 1, message);
    };
    std::vector<std::unique_ptr<LiveNode>> nodes;
    for (const auto& entry : roster.entries) {
      nodes.push_back(std::make_unique<LiveNode>(
          roster, entry.name, 0, factories.at(entry.name), send));
    }
    for (tick = 1000; tick < 1000 + kNumLiveTicks; ++tick) {
      if (tick == death) {
        nodes[2] = std::make_unique<LiveNode>(roster, "second", 1,
                                              factories.at("second"), send);
      }
      if (tick == 1100) {
        nodes[0]->Put(Command{"COMMAND_ADD", Bus::Encode(toy::Number(0, 5))});
      }
      for (size_t i = 0; i < nodes.size(); ++i) {
        if (i > 0 && chance(faults.skipped)) continue;
        for (const auto& [due, message] : wire) {
          if (due <= tick) nodes[i]->Put(message);
        }
        nodes[i]->Step(tick);
      }
      std::erase_if(wire, [&](const auto& m) { return m.first < tick - 1; });
    }
    num_lost_ = nodes[3]->arrivals().num_lost();
    log.Flush();
  }

  LiveReplayResult ReplayOf(const std::string& name) const {
    return ReplayLive(LiveLog::Load(dir_), ToyRoster(), name,
                      ToyFactories(kForever).at(name));
  }
  void ExpectIdentical() const {
    for (const auto& entry : ToyRoster().entries) {
      const LiveReplayResult result = ReplayOf(entry.name);
      EXPECT_EQ(result.difference, std::nullopt) << entry.name;
      EXPECT_THAT(result.gaps, IsEmpty()) << entry.name;
      EXPECT_EQ(result.num_unrecorded, 0) << entry.name;
      EXPECT_THAT(result.skipped, IsEmpty()) << entry.name;
      EXPECT_GT(result.num_messages, 80) << entry.name;
    }
  }
  // Writes the log again without the messages that `is_gone` names.
  void Drop(const std::function<bool(const Message&)>& is_gone) {
    const auto path = dir_ / "cell-0001.lcmlog";
    std::vector<Message> kept;
    EventLogReader reader(path);
    reader.Finish();
    while (auto event = reader.Next()) {
      const auto message = MessageFromWire(event->channel, event->bytes);
      if (!is_gone(*message)) kept.push_back(*message);
    }
    EventLogWriter writer(path);
    for (const Message& m : kept) writer.Write(m.tick, m.channel, *m.bytes);
    writer.Flush();
  }

  std::filesystem::path dir_ = NewTestFolder();
  std::map<std::string, int64_t> num_lost_;
};

TEST_F(LiveTest, ACalmCellReplaysAndHasNothingToReport) {
  Run(1, {});
  ExpectIdentical();
  const LiveLog log = LiveLog::Load(dir_);
  EXPECT_THAT(log.Problems(ToyRoster()), IsEmpty());
  EXPECT_THAT(log.LateMessages(ToyRoster()), IsEmpty());
  EXPECT_TRUE(LiveLog::IsLive(LogsOf(dir_)));
}

TEST_F(LiveTest, ReplaysWhatWasLostDoubledLateAndSkipped) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    Run(seed, {.lost = 0.05, .doubled = 0.1, .slow = 0.3, .skipped = 0.2});
    ExpectIdentical();
  }
}

TEST_F(LiveTest, ReplaysEachIncarnation) {
  Run(2, {.slow = 0.1}, 1200);
  ExpectIdentical();
}

TEST_F(LiveTest, NamesALostMessage) {
  Run(3, {.lost = 0.02});
  const auto problems = LiveLog::Load(dir_).Problems(ToyRoster());
  EXPECT_THAT(
      problems,
      Contains(HasSubstr("third did not get SUM sender 2 (second) seq")));
  EXPECT_GT(num_lost_.at("SUM"), 0);
}

TEST_F(LiveTest, NamesALateMessage) {
  Run(4, {.slow = 0.02});
  EXPECT_THAT(LiveLog::Load(dir_).LateMessages(ToyRoster()),
              Contains(HasSubstr("first got SOURCE sender 0 seq")));
}

TEST_F(LiveTest, NamesAMessageThatTheLogLacks) {
  Run(5, {});
  Drop([](const Message& m) { return m.channel == "SOURCE" && m.seq == 77; });
  EXPECT_THAT(LiveLog::Load(dir_).Problems(ToyRoster()),
              Contains("the log lacks SOURCE sender 0 (source) seq 77"));
  EXPECT_THAT(ReplayOf("first").gaps,
              Contains(HasSubstr("the step got SOURCE sender 0 seq 77, which "
                                 "the log lacks")));
  EXPECT_EQ(ReplayOf("source").num_unrecorded, 1);
}

TEST_F(LiveTest, FindsAForgedOutput) {
  Run(6, {});
  const auto path = dir_ / "cell-0002.lcmlog";
  Bytes bytes = Bus::Encode(toy::Number(1, 2));
  WriteIdentity(1010, 1, 100'000, bytes);
  EventLogWriter writer(path);
  writer.Write(0, "DOUBLE", bytes);
  writer.Flush();
  EXPECT_THAT(*ReplayOf("first").difference,
              HasSubstr("DOUBLE seq 100000 was not recomputed"));
}

TEST_F(LiveTest, SkipsAnIncarnationThatBeganBeforeTheLog) {
  Run(7, {}, 1300);
  Drop([](const Message& m) { return m.tick < 1010; });
  const LiveReplayResult result = ReplayOf("second");
  EXPECT_THAT(result.skipped, testing::SizeIs(1));
  EXPECT_GT(result.num_messages, 0);
  EXPECT_EQ(result.difference, std::nullopt);
}

}  // namespace
}  // namespace cell
