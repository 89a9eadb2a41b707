#include "services/vtb/vtb.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/command_episode_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/truth_contacts_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/stepper.h"
#include "tests/test_folder.h"

namespace cell {

using namespace vtb;
namespace {

/// The testbed on a bus that a test feeds.
class Bench {
 public:
  explicit Bench(const std::string& demonstration = "two_pegs",
                 uint64_t seed = 1000, const Deployment& files = Files())
      : stepper_({.name = "vtb"}),
        vtb_(MakeVtb(stepper_, files, demonstration, seed)) {}

  /// The messages of the next tick, by channel.
  std::multimap<std::string, Message> Tick(std::vector<Message> inputs = {}) {
    ++tick_;
    std::multimap<std::string, Message> outputs;
    if (stepper_.Accept(tick_, std::move(inputs)) == Stepper::State::kReady) {
      for (Message& message : stepper_.Run()) {
        outputs.emplace(message.channel, message);
      }
    }
    return outputs;
  }
  bool IsOver() const {
    return stepper_.end_tick() && tick_ >= *stepper_.end_tick();
  }
  int32_t tick() const { return tick_; }
  Stepper& stepper() { return stepper_; }

  static Deployment Files() {
    Deployment deployment;
    deployment.config_dir = CELL_SOURCE_DIR "/deploy/config";
    deployment.task_dir = CELL_SOURCE_DIR "/deploy/tasks/cranfield";
    return deployment;
  }

 private:
  Stepper stepper_;
  std::unique_ptr<Service> vtb_;
  int32_t tick_ = 0;
};

template <class M>
M Decoded(const Message& message) {
  const auto decoded = Decode<M>(message);
  EXPECT_TRUE(decoded) << message.channel;
  return decoded.value_or(M{});
}

Message CommandOf(int8_t action, const std::string& demonstration,
                  int64_t deadline_utime, int32_t tick) {
  command_episode_t command{};
  command.deadline_utime = deadline_utime;
  command.action = action;
  command.demonstration = demonstration;
  command.seed = 5;
  Bytes bytes = Bus::Encode(command);
  WriteIdentity(tick, 0, tick, bytes);
  return *MessageFromWire("COMMAND_EPISODE", std::move(bytes));
}

TEST(Vtb, ShowsAnEpisodeFromTickOneAndEndsTheRun) {
  Bench bench;
  int num_truth = 0, end_tick = 0;
  while (!bench.IsOver() && bench.tick() < 20'000) {
    const auto outputs = bench.Tick();
    num_truth += static_cast<int>(outputs.count("TRUTH_POSES"));
    if (bench.tick() == 1) {
      ASSERT_EQ(outputs.count("EPISODE"), 1u);
    }
    const auto found = outputs.find("EPISODE");
    if (found == outputs.end()) continue;
    const auto episode = Decoded<episode_t>(found->second);
    EXPECT_EQ(episode.id, 1);
    EXPECT_EQ(episode.task, "cranfield");
    EXPECT_EQ(episode.demonstration, "two_pegs");
    EXPECT_EQ(episode.seed, 1000);
    EXPECT_EQ(episode.header.utime, bench.tick() * kTickUs);
    if (episode.phase == episode_t::END) end_tick = bench.tick();
  }
  EXPECT_GT(end_tick, 1000);
  EXPECT_EQ(bench.tick(), end_tick + 125);
  EXPECT_EQ(num_truth, bench.tick() / 4);
}

TEST(Vtb, TruthNamesPartsHandsAndWhatTouches) {
  Bench bench;
  bench.Tick();
  std::multimap<std::string, Message> outputs;
  while (outputs.count("TRUTH_POSES") == 0) outputs = bench.Tick();
  const auto poses =
      Decoded<truth_poses_t>(outputs.find("TRUTH_POSES")->second);
  std::set<std::string> names;
  for (const body_pose_t& body : poses.bodies) names.insert(body.name);
  EXPECT_EQ(names.size(), poses.bodies.size());
  EXPECT_EQ(poses.bodies.front().name, "base");
  for (const char* name : {"face_plate", "hand_left.palm", "hand_right.fingers",
                           "gripper_left.jaw_1", "gripper_right.finger_3"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  const auto contacts =
      Decoded<truth_contacts_t>(outputs.find("TRUTH_CONTACTS")->second);
  EXPECT_EQ(contacts.contacts.size(), 9u);  // each free part on the table
}

TEST(Vtb, LeavesTheWristSensorsToADeviceOfTheirOwn) {
  Deployment files = Bench::Files();
  const auto folder = NewTestFolder();
  std::filesystem::copy(files.config_dir, folder);
  std::stringstream text;
  text << std::ifstream(folder / "vtb.yaml").rdbuf();
  const std::string key = "  sensors: true";
  std::string changed = text.str();
  changed.replace(changed.find(key), key.size(), "  sensors: false");
  std::ofstream(folder / "vtb.yaml") << changed;
  files.config_dir = folder;

  Bench all, without("two_pegs", 1000, files);
  EXPECT_EQ(all.Tick().count("WRENCH_RIGHT"), 1u);
  const auto outputs = without.Tick();
  EXPECT_EQ(outputs.count("WRENCH_RIGHT"), 0u);
  EXPECT_EQ(outputs.count("ARM_STATE_RIGHT"), 1u);
}

TEST(Vtb, TwoRunsPublishTheSameBytes) {
  std::vector<int64_t> digests[2];
  for (auto& run : digests) {
    Bench bench("assembly_two_hands", 1001);
    while (bench.tick() < 1000) {
      for (const auto& [channel, message] : bench.Tick()) {
        run.push_back(DigestOf(*message.bytes));
      }
    }
  }
  EXPECT_GT(digests[0].size(), 500u);
  EXPECT_EQ(digests[0], digests[1]);
}

/// Ticks of a run whose cell is held from tick 100 on.
class HeldRun {
 public:
  HeldRun(const std::string& demonstration, bool has_operator)
      : bench_(demonstration) {
    while (!bench_.IsOver() && bench_.tick() < 4000) {
      std::vector<Message> inputs;
      const int32_t tick = bench_.tick() + 1;
      if (tick == 50 && has_operator) {
        command_mode_t command{};
        command.action = command_mode_t::HOLD;
        command.deadline_utime = tick * kTickUs;
        inputs.push_back(MessageAt("COMMAND_MODE", command, tick));
      }
      if (tick >= 100 && tick % 62 == 38) {
        operating_mode_t mode{};
        mode.mode = motion_permit_t::HOLD;
        mode.hold = motion_permit_t::AT_ONCE;
        mode.reason = "an arm has stopped";
        inputs.push_back(MessageAt("MODE", mode, tick));
      }
      OnOutputs(bench_.Tick(std::move(inputs)));
    }
  }
  const std::optional<int32_t>& end() const { return end_; }
  const std::vector<alert_t>& alerts() const { return alerts_; }
  int num_episodes() const { return num_episodes_; }

 private:
  template <class M>
  static Message MessageAt(const std::string& channel, const M& message,
                           int32_t tick) {
    Bytes bytes = Bus::Encode(message);
    WriteIdentity(tick, 0, tick, bytes);
    return *MessageFromWire(channel, std::move(bytes));
  }
  void OnOutputs(const std::multimap<std::string, Message>& outputs) {
    for (const auto& [channel, message] : outputs) {
      if (channel == "ALERT") alerts_.push_back(Decoded<alert_t>(message));
      if (channel != "EPISODE") continue;
      const auto episode = Decoded<episode_t>(message);
      num_episodes_ += episode.phase == episode_t::START;
      if (episode.phase == episode_t::END) end_ = bench_.tick();
    }
  }

  Bench bench_;
  std::optional<int32_t> end_;
  std::vector<alert_t> alerts_;
  int num_episodes_ = 0;
};

TEST(Vtb, EndsTheRunOfACellThatIsHeldAndHasNoOperator) {
  const HeldRun run("execution+execution", false);
  ASSERT_TRUE(run.end().has_value());
  EXPECT_EQ(*run.end(), 100 + 2500);  // operator_patience_s
  EXPECT_EQ(run.num_episodes(), 1) << "the next one would be held, too";
  ASSERT_EQ(run.alerts().size(), 1u);
  EXPECT_EQ(run.alerts()[0].cause, alert_t::UNATTENDED);
  EXPECT_NE(run.alerts()[0].text.find("an arm has stopped"), std::string::npos);
}

TEST(Vtb, WaitsForAnOperatorWhoIsThere) {
  const HeldRun run("execution", true);
  EXPECT_FALSE(run.end().has_value());
  EXPECT_TRUE(run.alerts().empty());
}

TEST(Vtb, AStartCommandEndsTheEpisodeAndBeginsAnotherAfterAGap) {
  Bench bench;
  while (bench.tick() < 50) bench.Tick();
  std::vector<std::pair<int32_t, episode_t>> episodes;
  const auto tick = [&](std::vector<Message> inputs) {
    const auto outputs = bench.Tick(std::move(inputs));
    if (const auto found = outputs.find("EPISODE"); found != outputs.end()) {
      const auto episode = Decoded<episode_t>(found->second);
      if (episode.phase == episode_t::START ||
          episode.phase == episode_t::END) {
        episodes.emplace_back(bench.tick(), episode);
      }
    }
  };
  tick({CommandOf(command_episode_t::START, "assembly", 1'000'000, 51)});
  while (bench.tick() < 400 && !bench.IsOver()) tick({});
  EXPECT_FALSE(bench.IsOver());
  ASSERT_EQ(episodes.size(), 2u);
  EXPECT_EQ(episodes[0].first, 51);
  EXPECT_EQ(episodes[0].second.phase, episode_t::END);
  EXPECT_EQ(episodes[1].first, 51 + 125);
  EXPECT_EQ(episodes[1].second.id, 2);
  EXPECT_EQ(episodes[1].second.demonstration, "assembly");
  EXPECT_EQ(episodes[1].second.seed, 5);
}

TEST(Vtb, RejectsCommandsThatAreLateOrMakeNoSense) {
  Bench bench;
  while (bench.tick() < 50) bench.Tick();
  const auto rejects = [&](const Message& command) {
    const auto before = bench.stepper().num_rejected();
    const auto outputs = bench.Tick({command});
    return bench.stepper().num_rejected() != before &&
           outputs.count("EPISODE") == 0;
  };
  EXPECT_TRUE(rejects(CommandOf(command_episode_t::START, "assembly", 1, 51)));
  EXPECT_TRUE(
      rejects(CommandOf(command_episode_t::START, "dance", 9'000'000, 52)));
  EXPECT_TRUE(rejects(CommandOf(7, "assembly", 9'000'000, 53)));
}

TEST(Vtb, AnEndCommandEndsTheRun) {
  Bench bench;
  while (bench.tick() < 50) bench.Tick();
  const auto outputs =
      bench.Tick({CommandOf(command_episode_t::END, "", 9'000'000, 51)});
  EXPECT_EQ(outputs.count("EPISODE"), 1u);
  while (!bench.IsOver() && bench.tick() < 1000) bench.Tick();
  EXPECT_EQ(bench.tick(), 51 + 125);
}

}  // namespace
}  // namespace cell
