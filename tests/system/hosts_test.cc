// A live cell on three hosts (docs/operating.md): each host receives all
// messages of the others, and the log is complete; with a ttl of 0 none leave.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cell/health_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/lcm_port.h"
#include "common/bus/live_log.h"
#include "common/bus/run_log.h"
#include "common/imaging/rgbd_frame.h"
#include "common/node/cell_files.h"
#include "services/cell/running/process_group.h"
#include "tests/system/host_network.h"
#include "tests/system/run_cell.h"

namespace cell {

using namespace cli;
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

constexpr char kAlone[] = "udpm://239.255.76.67:7667";
constexpr char kTogether[] = "udpm://239.255.76.67:7667?ttl=1";

using Names = std::vector<std::string>;
const std::map<std::string, Names> kServicesOn = {
    {"devices",
     {"vtb", "supervisor", "camera_set@1", "camera_set@2", "camera_set@3"}},
    {"watching", {"tracker", "sec_builder", "recognizer"}},
    {"logging", {"recorder"}}};

// The messages received on a host.
struct Ear {
  explicit Ear(const LcmAddress& address)
      : main(address.MainUrl()), control(address.ControlUrl()) {
    main.Subscribe(".*", [this](const std::string& channel, Bytes bytes) {
      const auto message = MessageFromWire(channel, std::move(bytes));
      if (!message) return;  // LCM's own
      ++num_messages[channel];
      services.insert(BaseOf(message->sender));
    });
    control.Subscribe(kHealthChannel, [this](const std::string& channel,
                                             Bytes bytes) {
      const auto message = MessageFromWire(channel, std::move(bytes));
      const auto health = message ? Decode<health_t>(*message) : std::nullopt;
      if (health) ++num_healths[health->service];
    });
  }

  LcmPort main;
  LcmPort control;
  std::map<std::string, int> num_messages;  // by channel
  std::map<std::string, int> num_healths;   // by service
  std::set<size_t> services;                // that spoke; as in the roster
};

class Hosts : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    Names hosts;
    for (const auto& [host, names] : kServicesOn) hosts.push_back(host);
    network_.emplace(hosts);
    start_s_ = std::time(nullptr);
  }

  fs::path RunOn(const std::string& host) const {
    return dir_ / host / "runs/current";
  }
  Ear& EarOn(const std::string& host) { return *ears_.at(host); }
  /// [us of the monotonic clock]
  double EpochOn(const std::string& host) const {
    return std::stod(TextOf(dir_ / host / "epoch"));
  }

  /// The recorder first, so that it misses nothing; the world last.
  void StartAll(const std::string& url) {
    for (const char* host : {"logging", "watching", "devices"}) {
      ASSERT_NO_FATAL_FAILURE(Start(host, url));
    }
  }

  /// The recorder last, when it has written all that has come.
  void StopAll() {
    for (const char* host : {"devices", "watching"}) {
      for (const std::string& name : kServicesOn.at(host)) Stop(name);
    }
    int& num_healths = EarOn("logging").num_healths["recorder"];
    const int enough = num_healths + 2;
    EXPECT_TRUE(Await([&] { return num_healths >= enough; }));
    Stop("recorder");
  }

  /// Listens on every host until `is_done`, at most for a minute.
  bool Await(const std::function<bool()>& is_done) {
    constexpr int kStepMs = 10;
    const auto until =
        std::chrono::steady_clock::now() + std::chrono::minutes(1);
    std::vector<LcmPort*> ports;
    for (const auto& [host, ear] : ears_) {
      ports.insert(ports.end(), {&ear->main, &ear->control});
    }
    while (std::chrono::steady_clock::now() < until) {
      WaitForAny(ports, kStepMs);
      for (LcmPort* port : ports) port->Drain();
      if (is_done()) return true;
    }
    return false;
  }
  /// So many messages on each of the channels.
  bool AwaitOn(const std::string& host, const Names& channels, int num) {
    return Await([&] {
      return std::all_of(channels.begin(), channels.end(),
                         [&](const std::string& channel) {
                           return EarOn(host).num_messages[channel] >= num;
                         });
    });
  }

  /// Of the services that have been heard on a host.
  Names HeardOn(const std::string& host) {
    const Roster roster =
        FindCellFiles((RunOn(host) / "deploy").string()).roster;
    Names names;
    for (const size_t index : EarOn(host).services) {
      names.push_back(roster.entries.at(index).name);
    }
    return names;
  }

  std::optional<HostNetwork> network_;

 private:
  void Start(const std::string& host, const std::string& url) {
    const ShellResult prepared =
        Cell("prepare --cameras --seed 7 --demonstration two_pegs --start " +
             std::to_string(start_s_) + " --state-dir " + host);
    ASSERT_EQ(prepared.code, 0) << prepared.output;
    const auto stay = network_->On(host);
    ears_[host] = std::make_unique<Ear>(LcmAddress::Parse(url));
    for (const std::string& name : kServicesOn.at(host)) {
      StartOne(host, name, url);
      ASSERT_TRUE(Await([&] { return EarOn(host).num_healths.contains(name); }))
          << name << ": " << TextOf(dir_ / (name + ".out"));
    }
  }

  void StartOne(const std::string& host, const std::string& name,
                const std::string& url) {
    const auto [program, instance] = ServiceName::Parse(name);
    Names arguments = {"--live",
                       "--url",
                       url,
                       "--state-dir",
                       dir_ / host,
                       "--deploy",
                       RunOn(host) / "deploy",
                       "--run-dir",
                       RunOn(host)};
    if (url == kTogether) arguments.push_back("--allow-network");
    if (!instance.empty()) {
      arguments.insert(arguments.end(), {"--instance", instance});
    }
    if (name == "vtb") {
      arguments.insert(arguments.end(),
                       {"--demonstration", "two_pegs", "--seed", "7"});
    }
    processes_.Start(name, fs::path(CELL_BIN_DIR) / program, arguments,
                     dir_ / (name + ".out"));
  }

  void Stop(const std::string& name) {
    processes_.Kill(name, SIGTERM);
    EXPECT_TRUE(Await([&] {
      for (const auto& death : processes_.TakeDeaths()) {
        EXPECT_TRUE(death.is_clean) << death.name << ": " << death.cause;
      }
      return !processes_.IsRunning(name);
    })) << name;
  }

  std::time_t start_s_ = 0;
  std::map<std::string, std::unique_ptr<Ear>> ears_;
  ProcessGroup processes_;
};

// Decodes each; returns the length of the longest.
size_t CheckFrames(const LiveLog& log) {
  size_t longest = 0;
  for (const Message* message : log.InOrder()) {
    if (!message->channel.starts_with("FRAME_")) continue;
    longest = std::max(longest, message->bytes->size());
    const auto decoded = Decode<rgbd_frame_t>(*message);
    const auto frame = decoded ? FrameFromMessage(*decoded) : std::nullopt;
    EXPECT_TRUE(frame) << message->channel << " seq " << message->seq;
    if (!frame) continue;
    const auto& counts = frame->depth.counts;
    EXPECT_TRUE(std::any_of(counts.begin(), counts.end(),
                            [](uint16_t count) { return count > 0; }));
  }
  return longest;
}

TEST_F(Hosts, ReceiveAndLogSmallMessagesAndWholeFrames) {
  StartAll(kTogether);
  ASSERT_TRUE(
      AwaitOn("logging", {"TRACKS", "FRAME_1", "FRAME_2", "FRAME_3"}, 40));
  StopAll();
  Names all;
  for (const auto& [host, names] : kServicesOn) {
    all.insert(all.end(), names.begin(), names.end());
  }
  for (const auto& [host, names] : kServicesOn) {
    EXPECT_THAT(HeardOn(host), UnorderedElementsAreArray(all)) << host;
    // They were started seconds apart, but share a clock here.
    EXPECT_NEAR(EpochOn(host), EpochOn("devices"), 5e5) << host;
  }

  const ShellResult check = Cell("log check logging/runs/current");
  EXPECT_EQ(check.code, 0) << check.output;
  // Of all that was said elsewhere nothing is missing, and not a byte differs.
  const ShellResult replay = Cell("replay logging/runs/current --check");
  EXPECT_EQ(replay.code, 0) << replay.output;
  for (const char* host : {"devices", "watching"}) {
    for (const std::string& name : kServicesOn.at(host)) {
      EXPECT_THAT(replay.output,
                  ContainsRegex(name + " +[0-9]+ messages? of 1 start, "
                                       "byte-identical\n"));
    }
  }
  constexpr size_t kOneDatagram = 65'499;  // liblcm cuts what is longer
  EXPECT_GT(CheckFrames(LiveLog::Load(RunOn("logging"))), kOneDatagram);
}

TEST_F(Hosts, ReceiveNothingFromEachOtherWithoutATtl) {
  StartAll(kAlone);
  ASSERT_TRUE(
      AwaitOn("devices", {"TRUTH_POSES", "FRAME_1", "FRAME_2", "FRAME_3"}, 10));
  StopAll();
  for (const auto& [host, names] : kServicesOn) {
    EXPECT_THAT(HeardOn(host), UnorderedElementsAreArray(names)) << host;
  }
  EXPECT_FALSE(LiveLog::IsLive(RequireLogsOf(RunOn("logging"))))
      << "the log holds steps of other hosts' services";
}

TEST_F(Hosts, RefuseATtlWithoutAllowNetwork) {
  const auto stay = network_->On("devices");
  for (const std::string program : {"tracker", "vtb"}) {
    const ShellResult run =
        Shell(CELL_BIN_DIR "/" + program + " --live --state-dir " +
              dir_.string() + " --url '" + kTogether + "'");
    EXPECT_EQ(run.code, 2) << program;
    EXPECT_THAT(run.output, HasSubstr("add --allow-network")) << program;
  }
  for (const std::string command :
       {"top", "record", "hold", "goal round_pegs"}) {
    const ShellResult run = Cell(command + " --url '" + kTogether + "'");
    EXPECT_EQ(run.code, 1) << command;
    EXPECT_THAT(run.output, HasSubstr("add --allow-network")) << command;
  }
}

TEST_F(Hosts, RefuseAStartInTheFuture) {
  const ShellResult run = Cell("prepare --state-dir . --start 9999999999");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("--start 9999999999: is in the future"));
  EXPECT_FALSE(fs::exists(dir_ / "runs"));
}

TEST_F(Hosts, PassTheDoctorWithSeveralHosts) {
  const auto stay = network_->On("devices");
  const std::string doctor = std::string("doctor --url '") + kTogether + "'";
  const ShellResult told = Cell(doctor + " --several-hosts");
  EXPECT_THAT(told.output, HasSubstr("ok   multicast route: 239.255.76.67 goes "
                                     "to eth0\n"));
  EXPECT_THAT(told.output, HasSubstr("ok   ttl: several hosts\n"));
  EXPECT_THAT(Cell(doctor).output, HasSubstr("BAD  ttl: "));
}

}  // namespace
}  // namespace cell
