// The library as a process over LCM, killed while it stores: it keeps what it
// has answered, and leaves the same bytes as in one process.
#include <gmock/gmock.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>

#include "cell/store_answer_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/lcm_clock.h"
#include "common/bus/lcm_node.h"
#include "common/bus/lcm_port.h"
#include "common/bus/manifest.h"
#include "common/bus/private_network.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/bus/sim_bus.h"
#include "services/cell/running/process_group.h"
#include "services/library/content_file.h"
#include "services/library/open_store.h"
#include "services/library/sqlite_action_store.h"
#include "tests/test_folder.h"
#include "tests/unit/keeping_cell.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace library;

using namespace cli;
namespace {

namespace fs = std::filesystem;

constexpr int32_t kNumTicks = 1200;
constexpr int32_t kTicksBetweenKills = 40;
constexpr double kGiveUpS = 60;

/// The library is the program; the others are threads of this one.
class LibraryDeath : public testing::Test {
 protected:
  void SetUp() override {
    EnterPrivateNetwork();
    dir_ = NewTestFolder();
    fs::create_directories(dir_ / "run");
    const Deployment shipped = ShippedDeployment();
    fs::copy(shipped.config_dir.parent_path(), dir_ / "deploy",
             fs::copy_options::recursive);
    const fs::path config = dir_ / "deploy" / "config";
    std::ofstream roster(config / "roster.yaml");
    roster << "task: cranfield\nservices:\n";
    for (const Roster::Entry& entry : keeping::TheRoster().entries) {
      roster << "  - {name: " << entry.name << ", latency: 1}\n";
    }
    deployment_ = {config, dir_ / "deploy" / "tasks" / "cranfield"};
  }
  void TearDown() override {
    if (!HasFailure()) fs::remove_all(dir_);
  }

  void StartLibrary() {
    library_.Start("library", fs::path(CELL_BIN_DIR) / "library",
                   {"--deploy", (dir_ / "deploy").string(), "--run-dir",
                    (dir_ / "run").string()},
                   dir_ / "library.out");
  }
  std::string LibrarySaid() const {
    std::ifstream stream(dir_ / "library.out");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// Kills the library again and again until the clock has ended the run.
  void RunOverLcm() {
    Deployment recorded = deployment_;
    recorded.run_dir = dir_ / "run";
    auto factories = keeping::Factories(recorded, kNumTicks);
    const LcmAddress address;
    std::atomic<bool> stop = false, is_done = false;
    std::vector<std::thread> threads;
    const auto run = [&](auto function) {
      threads.emplace_back([&, function] {
        try {
          function();
        } catch (const std::exception& e) {
          const std::lock_guard lock(mutex_);
          failure_ += std::string(e.what()) + "\n";
          stop = true;
        }
      });
    };
    int32_t next_kill = kTicksBetweenKills;
    LcmPort ticks(address.MainUrl());
    ticks.Subscribe("TICK", [&](const std::string&, Bytes bytes) {
      if (ReadWireHeader(bytes).tick < next_kill) return;
      next_kill = ReadWireHeader(bytes).tick + kTicksBetweenKills;
      library_.Kill("library", SIGKILL);
    });
    for (const char* name : {"asker", "recorder"}) {
      run([&, name] {
        RunLcmNode(address, keeping::TheRoster(), name, factories.at(name), {},
                   stop);
      });
    }
    run([&] {
      RunLcmClock(address, keeping::TheRoster(), factories.at("time"),
                  {.giveup_s = kGiveUpS}, {}, stop);
      is_done = true;
    });
    StartLibrary();
    while (!is_done && !stop) {
      WaitForAny({&ticks}, 20);
      ticks.Drain();
      for (const auto& death : library_.TakeDeaths()) {
        if (!death.is_clean) StartLibrary();
      }
    }
    for (std::thread& thread : threads) thread.join();
    library_.StopAll(3000);
  }

  void ExpectAnsweredExperiencesIn(const RunLog& log) const;

  fs::path dir_;
  Deployment deployment_;
  ProcessGroup library_;
  std::mutex mutex_;
  std::string failure_;
};

/// Every experience that the library has answered is in its file.
void LibraryDeath::ExpectAnsweredExperiencesIn(const RunLog& log) const {
  const SqliteActionStore store(dir_ / "run" / kDatabaseName,
                                SqliteActionStore::Mode::kExisting);
  const LibraryContent content = store.Content();
  std::map<int64_t, std::string> kept;
  for (const ExperienceRecord& experience : content.experiences) {
    kept[experience.id] = experience.action;
  }
  std::map<int64_t, std::string> answered;
  for (const auto& [tick, entry] : log.ticks()) {
    for (const Message& message : entry.messages) {
      if (message.channel != "STORED") continue;
      const auto answer = Decode<store_answer_t>(message);
      ASSERT_TRUE(answer);
      if (answer->channel != "EXPERIENCE_REQUEST" ||
          answer->outcome != store_answer_t::STORED) {
        continue;
      }
      const auto asked = static_cast<int32_t>(answer->header.utime / kTickUs);
      answered[answer->id] = keeping::ExperienceRequestOf(asked).action;
    }
  }
  EXPECT_GT(answered.size(), static_cast<size_t>(kNumTicks) / 2);
  for (const auto& [id, action] : answered) EXPECT_EQ(kept[id], action);
}

TEST_F(LibraryDeath, LeavesTheBytesOfOneProcessAndReplays) {
  RunOverLcm();
  ASSERT_EQ(failure_, "") << LibrarySaid();
  const RunLog log = RunLog::Load(dir_ / "run");
  EXPECT_THAT(log.problems(), testing::IsEmpty());
  std::vector<SimBus::Outage> outages;
  for (const auto& [k, entry] : log.ticks()) {
    for (const joined_t& joined : entry.manifest.joined) {
      if (joined.death_tick < 0) continue;
      outages.push_back({joined.name, joined.death_tick, k});
    }
  }
  EXPECT_GE(outages.size(), 15u) << LibrarySaid();

  SimBus bus(keeping::TheRoster(), keeping::Factories(deployment_, kNumTicks),
             outages);
  while (bus.Step()) {
    const tick_t& tick = bus.last_tick();
    const auto it = log.ticks().find(tick.header.tick);
    ASSERT_NE(it, log.ticks().end());
    ASSERT_EQ(TickMessage(tick).digest, TickMessage(it->second.manifest).digest)
        << "tick " << tick.header.tick;
  }
  EXPECT_EQ(log.ticks().rbegin()->first, bus.last_tick().header.tick);

  ExpectAnsweredExperiencesIn(log);

  Deployment repeated = deployment_;
  repeated.repeated_dir = dir_ / "run";
  const ReplayResult replay =
      Replay(log, keeping::TheRoster(), "library",
             keeping::Factories(repeated, kNumTicks).at("library"));
  EXPECT_EQ(replay.difference, std::nullopt);
  EXPECT_GT(replay.num_messages, kNumTicks);
}

}  // namespace
}  // namespace cell
