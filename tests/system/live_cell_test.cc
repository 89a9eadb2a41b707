// A live cell of real processes: its log replays after load, and it keeps
// running under attack.
#include "tests/system/live_cell.h"

#include <gmock/gmock.h>

#include <random>
#include <thread>

#include "cell/key_frame_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/live_log.h"
#include "common/bus/message.h"

namespace cell {
namespace {

using testing::HasSubstr;
using testing::Not;

class Live : public LiveCell {};

// The last column of top's table of channels, added up.
int64_t NumRejected(const std::string& top) {
  std::istringstream lines(top.substr(top.find("channel")));
  std::string line;
  std::getline(lines, line);  // its head
  int64_t sum = 0;
  while (std::getline(lines, line) && !line.empty()) {
    sum += std::stoll(line.substr(line.rfind(' ')));
  }
  return sum;
}

TEST_F(Live, AMinuteUnderLoadReplaysByteForByte) {
  Start("assembly");
  std::atomic<bool> stop = false;
  std::vector<std::thread> load;
  for (int i = 0; i < 2; ++i) {
    load.emplace_back([&stop] {
      while (!stop) {
      }
    });
  }
  constexpr int kMinuteMs = 60'000;
  Await([] { return false; }, kMinuteMs);
  stop = true;
  for (std::thread& thread : load) thread.join();
  Stop();
  const ShellResult replay = Cell("replay runs/current --check");
  EXPECT_THAT(replay.output, Not(HasSubstr("DIFFERENT")));
  EXPECT_THAT(replay.output, Not(HasSubstr("log: ")));
  for (const std::string& name : names_) {
    if (name == "recorder") continue;
    EXPECT_THAT(replay.output,
                testing::ContainsRegex(name + " +[0-9]+ messages? of 1 start, "
                                              "byte-identical"));
  }
  EXPECT_EQ(replay.code, 0) << replay.output;
}

TEST_F(Live, TenThousandForgeriesCrashNoServiceAndAreCounted) {
  std::map<std::string, std::vector<Bytes>> samples;
  main_->Subscribe(".*", [&](const std::string& channel, Bytes bytes) {
    constexpr size_t kMaxSamples = 20;
    auto& of_channel = samples[channel];
    if (bytes.size() > kWireHeaderEnd && of_channel.size() < kMaxSamples) {
      of_channel.push_back(std::move(bytes));
    }
  });
  Start("two_pegs");
  constexpr int kSampleMs = 60'000;
  ASSERT_TRUE(Await(
      [&] {
        return samples.size() > 10 && samples.contains("TRACKS") &&
               samples.contains("PREDICATES") && samples.contains("STATUS");
      },
      kSampleMs));
  const auto before = health_;

  constexpr int kNumForgeries = 10'000;
  constexpr int kBurst = 20;
  std::mt19937_64 random(1);
  LcmPort forger(LcmAddress{}.MainUrl());
  std::vector<std::string> channels;
  for (const auto& [channel, of_channel] : samples) {
    if (!of_channel.empty()) channels.push_back(channel);
  }
  for (int i = 0; i < kNumForgeries; ++i) {
    const std::string& channel = channels[random() % channels.size()];
    const auto& of_channel = samples.at(channel);
    Bytes bytes = of_channel[random() % of_channel.size()];
    // Every second one keeps its fingerprint and a valid header.
    const size_t from = i % 2 == 0 ? kWireHeaderEnd : 0;
    for (int flips = 0; flips < 8 && bytes.size() > from; ++flips) {
      bytes[from + random() % (bytes.size() - from)] =
          static_cast<uint8_t>(random() % 3 == 0 ? 0xff : random());
    }
    // Some begin a new incarnation of their sender, and so reach its readers.
    if (i % 4 == 0) {
      const WireHeader header = ReadWireHeader(bytes);
      WriteIdentity(header.tick, header.sender + 1000 * (1 + i), 0, bytes);
    }
    if (i % 5 == 0) bytes.resize(from + random() % (bytes.size() - from + 1));
    forger.Publish(channel, bytes);
    if (i % kBurst == 0) Await([] { return false; }, 10);
  }
  health_.clear();
  constexpr int kAnswerMs = 60'000;
  EXPECT_TRUE(
      Await([&] { return health_.size() >= names_.size(); }, kAnswerMs));
  EXPECT_TRUE(processes_.TakeDeaths().empty());
  constexpr int64_t kMaxGrowth = 64 << 20;
  int64_t num_unknown_senders = 0;
  for (const std::string& name : names_) {
    ASSERT_TRUE(health_.contains(name)) << name;
    EXPECT_LT(health_[name].resident_bytes - before.at(name).resident_bytes,
              kMaxGrowth)
        << name;
    EXPECT_EQ(health_[name].header.sender, before.at(name).header.sender)
        << name << " has started again";
    num_unknown_senders += health_[name].num_unknown_senders;
  }
  EXPECT_GT(num_unknown_senders, 0);
  const ShellResult top = Cell("top --reports 1 --period 10");
  EXPECT_EQ(top.code, 0);
  std::cout << top.output;
  EXPECT_GT(NumRejected(top.output), 100);
  Stop();
}

TEST_F(Live, PartOfASessionIsRecordedBesideTheRecorder) {
  Start("two_pegs");
  const ShellResult record = Cell("record --seconds 6 --out glimpse");
  const bool is_whole = record.output.find(" 0 lost") != std::string::npos;
  EXPECT_EQ(record.code, is_whole ? 0 : 1) << record.output;
  const ShellResult again = Cell("record --seconds 1 --out glimpse");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.output, HasSubstr("choose another --out"));
  Stop();
  // Its messages are those of the recorder's own log.
  const LiveLog own = LiveLog::Load(Run());
  const LiveLog glimpse = LiveLog::Load(dir_ / "glimpse");
  const auto messages = glimpse.InOrder();
  ASSERT_GT(messages.size(), 1000u);
  for (const Message* message : messages) {
    const Message* duplicate =
        own.Find({message->channel, message->sender, message->seq,
                  DigestOf(*message->bytes)});
    EXPECT_NE(duplicate, nullptr) << message->channel << " " << message->tick;
  }
  EXPECT_EQ(glimpse.incarnations().size(), own.incarnations().size());

  const ShellResult told = Cell("replay glimpse");
  int num_key_frames = 0;
  for (const Message* message : messages) {
    if (message->channel != "KEY_FRAME") continue;
    ++num_key_frames;
    const auto frame = Decode<key_frame_t>(*message->bytes);
    EXPECT_THAT(told.output,
                HasSubstr("key frame " + std::to_string(frame->index) + ":"));
  }
  EXPECT_GT(num_key_frames, 0);
  EXPECT_THAT(TextOf(dir_ / "glimpse/run.yaml"),
              HasSubstr("demonstration: \"two_pegs\"\nseed: 7\n"));
  EXPECT_EQ(told.code, is_whole ? 0 : 1) << told.output;
  EXPECT_THAT(Cell("replay glimpse --check").output,
              Not(HasSubstr("DIFFERENT")));
  EXPECT_EQ(Cell("view glimpse --at 1 --out picture.png").code, 0);
}

TEST_F(Live, WithoutACellARecordingReportsThatNothingCame) {
  const ShellResult record = Cell("record --seconds 0.3 --out glimpse");
  EXPECT_EQ(record.code, 1);
  EXPECT_THAT(record.output, HasSubstr("no cell was heard"));
  EXPECT_FALSE(std::filesystem::exists(dir_ / "glimpse"));
}

}  // namespace
}  // namespace cell
