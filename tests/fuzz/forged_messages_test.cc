// Forged payloads through checked decode and the handlers of every service
// that takes them: no death, bounded memory, rejects counted. Built with the
// address sanitizer by scripts/test.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "cell/ack_t.hpp"
#include "cell/action_record_t.hpp"
#include "cell/alert_t.hpp"
#include "cell/answer_t.hpp"
#include "cell/arm_report_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/command_confirm_t.hpp"
#include "cell/command_episode_t.hpp"
#include "cell/command_fault_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/command_name_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/experience_t.hpp"
#include "cell/health_t.hpp"
#include "cell/hello_t.hpp"
#include "cell/library_request_t.hpp"
#include "cell/relation_layers_t.hpp"
#include "cell/sense_request_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/status_t.hpp"
#include "cell/tick_t.hpp"
#include "cell/truth_contacts_t.hpp"
#include "cell/types_digest.h"
#include "common/arms/motion_messages.h"
#include "common/bus/bus_error.h"
#include "common/bus/clock.h"
#include "common/bus/decode.h"
#include "common/bus/lockstep_node.h"
#include "common/bus/process_usage.h"
#include "common/bus/sim_bus.h"
#include "common/config/deployment.h"
#include "common/imaging/rgbd_frame.h"
#include "common/skills/skill_arguments.h"
#include "services/cell/reporting/narrator.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/scoring/episode_observer.h"

namespace cell {

using namespace cli;
namespace {

constexpr int kNumForgeries = 100'000;
#if defined(__SANITIZE_ADDRESS__)
constexpr int64_t kMaxGrowth = 256 << 20;  // red zones, quarantine, shadow
#else
constexpr int64_t kMaxGrowth = 64 << 20;
#endif

const std::filesystem::path kDeploy =
    std::filesystem::path(CELL_SOURCE_DIR) / "deploy";
const Deployment kDeployment{kDeploy / "config",
                             kDeploy / "tasks" / "cranfield"};

Roster TheRoster() {
  return Roster::FromConfig(Config::Load(kDeploy / "config" / "roster.yaml"));
}

// A short way of the right arm in an empty cell, and the answer.
void AskForMotions(std::map<std::string, std::vector<Bytes>>& samples) {
  const CellLayout layout =
      CellLayout::FromConfig(kDeployment.OfTask("cell.yaml"));
  MotionRequest request;
  request.arm = "right";
  for (const ArmLayout& arm : layout.arms) {
    request.arms[arm.name].posture = HomePosture(arm);
  }
  request.goal = layout.FindArm("right")->home;
  MotionPlan plan;
  plan.arm = "right";
  plan.waypoints = {request.goal, request.goal};
  samples["MOTION_REQUEST"] = {Bus::Encode(ToMessage(request))};
  samples["MOTION_PLAN"] = {Bus::Encode(ToMessage(plan, 0))};
}

// Reports of arms, and messages to arms.
void AddOfArms(std::map<std::string, std::vector<Bytes>>& samples) {
  arm_report_t report{};
  report.request = -1;
  report.held = "head";
  report.reachable = {"face_plate", "pendulum", "shaft"};
  report.num_reachable = 3;
  for (const char* arm : {"left", "right"}) {
    report.arm = arm;
    const bool is_left = report.arm == "left";
    samples[is_left ? "ARM_REPORT_LEFT" : "ARM_REPORT_RIGHT"] = {
        Bus::Encode(report)};
  }
  skill_result_t result{};
  result.arm = "right";
  result.reason = "it jams";
  samples["SKILL_RESULT"] = {Bus::Encode(result)};
  asked_skill_t request{};
  request.arm = "right";
  request.skill = "insert";
  SetArguments({{"part", "shaft"}, {"site", "base.shaft"}}, &request);
  samples["SKILL_REQUEST"] = {Bus::Encode(request)};
  AskForMotions(samples);
  execution_t execution{};
  execution.text = "please do it";
  execution.needed.resize(1);
  execution.num_needed = 1;
  samples["EXECUTION"] = {Bus::Encode(execution)};
}

// Requests to the library to keep actions like those that it has, and an
// experience.
void AskLibrary(std::map<std::string, std::vector<Bytes>>& samples) {
  library_request_t request{};
  request.id = 1;
  samples["LIBRARY_REQUEST"] = {Bus::Encode(request)};
  for (const Bytes& bytes : samples.at("ACTION_RECORD")) {
    action_record_t record{};
    record.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
    record.id = 0;
    record.name += "Anew";
    samples["STORE_REQUEST"].push_back(Bus::Encode(record));
  }
  experience_t experience{};
  experience.action = "Insert";
  experience.agent = "person";
  experience.before.resize(1);
  experience.before[0].predicate = "Clear";
  experience.before[0].arguments = {"head"};
  experience.before[0].num_arguments = 1;
  experience.before[0].value = literal_t::TRUE_;
  experience.num_before = 1;
  samples["EXPERIENCE_REQUEST"] = {Bus::Encode(experience)};
  experience.id = 1;
  samples["EXPERIENCE"] = {Bus::Encode(experience)};
}

// What a camera would see: a slope in grey.
rgbd_frame_t AFrame() {
  RgbdFrame frame;
  frame.camera = "1";
  frame.view.width = frame.colour.width = frame.depth.width = 64;
  frame.view.height = frame.colour.height = frame.depth.height = 48;
  for (int i = 0; i < 64 * 48; ++i) {
    frame.depth.counts.push_back(static_cast<uint16_t>(10'000 + 3 * i));
    frame.colour.pixels.push_back({90, static_cast<uint8_t>(i / 16), 90});
  }
  return *FrameToMessage(frame, 150'000, 90);
}

// True messages of a short episode, some of each channel.
const std::map<std::string, std::vector<Bytes>>& Corpus() {
  static const auto corpus = [] {
    std::map<std::string, std::vector<Bytes>> samples;
    SimBus bus(TheRoster(), AllServices(kDeployment, "two_pegs", 1));
    constexpr size_t kPerChannel = 20;
    while (bus.Step()) {
      for (const Message& message : bus.last_messages()) {
        auto& of_channel = samples[message.channel];
        if (of_channel.size() < kPerChannel) {
          of_channel.push_back(*message.bytes);
        }
      }
      auto& ticks = samples["TICK"];
      if (ticks.size() < kPerChannel) {
        ticks.push_back(Bus::Encode(bus.last_tick()));
      }
    }
    command_episode_t command{};
    command.demonstration = "assembly";
    command.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_EPISODE"] = {Bus::Encode(command)};
    command_confirm_t confirm{};
    confirm.action = "PlaceRoundPeg";
    confirm.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_CONFIRM"] = {Bus::Encode(confirm)};
    command_fault_t fault{};
    fault.arm = "right";
    fault.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_FAULT"] = {Bus::Encode(fault)};
    command_goal_t goal{};
    goal.goal = "assembled";
    goal.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_GOAL"] = {Bus::Encode(goal)};
    command_mode_t mode{};
    mode.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_MODE"] = {Bus::Encode(mode)};
    command_name_t name{};
    name.name = "Insert";
    name.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_NAME"] = {Bus::Encode(name)};
    command_library_t edit{};
    edit.kind = command_library_t::MERGE;
    edit.name = "PlaceRoundPeg";
    edit.other = "PlaceSquarePeg";
    edit.deadline_utime = std::numeric_limits<int64_t>::max();
    samples["COMMAND_LIBRARY"] = {Bus::Encode(edit)};
    relation_layers_t layers{};
    layers.relations.resize(1);
    layers.relations[0].first = "base";
    layers.relations[0].second = "shaft";
    layers.relations[0].place = spatial_relation_t::CARRIES;
    layers.num_relations = 1;
    samples["RELATION_LAYERS"] = {Bus::Encode(layers)};
    samples["SENSE_REQUEST"] = {Bus::Encode(sense_request_t{})};
    AddOfArms(samples);
    AskLibrary(samples);
    samples["FRAME_1"] = {Bus::Encode(AFrame())};
    alert_t alert{};
    alert.text = "the way to the goal has become longer";
    samples["ALERT"] = {Bus::Encode(alert)};
    answer_t answer{};
    answer.channel = "COMMAND_GOAL";
    answer.text = "the task has no such goal";
    samples["ANSWER"] = {Bus::Encode(answer)};
    hello_t hello{};
    hello.name = "tracker";
    hello.nonce = 1;
    hello.types_digest = kTypesDigest;
    samples["HELLO"] = {Bus::Encode(hello)};
    ack_t ack{};
    ack.header.sender = 1;
    ack.run = 1;
    ack.nonce = 1;
    ack.flows.resize(1);
    ack.flows[0].channel = "TRACKS";
    ack.flows[0].sender = 1;
    ack.flows[0].count = 1;
    ack.flows[0].digests = {7};
    ack.num_flows = 1;
    samples["ACK"] = {Bus::Encode(ack)};
    health_t health{};
    health.service = "tracker";
    samples["HEALTH"] = {Bus::Encode(health)};
    return samples;
  }();
  return corpus;
}

class Forger {
 public:
  explicit Forger(uint64_t seed) : random_(seed) {}

  /// Every second forgery keeps fingerprint and header.
  Bytes Forge(const Bytes& original) {
    Bytes bytes = original;
    const bool is_sly = is_sly_;
    is_sly_ = !is_sly_;
    const size_t first = is_sly ? std::min(kWireHeaderEnd, bytes.size()) : 0;
    const size_t num_changes = 1 + Below(4);
    for (size_t i = 0; i < num_changes; ++i) Change(first, &bytes);
    if (Below(8) == 0) bytes.resize(first + Below(bytes.size() - first + 1));
    if (Below(16) == 0) bytes.resize(bytes.size() + Below(64), 0xa5);
    return bytes;
  }

 private:
  size_t Below(size_t n) { return n == 0 ? 0 : random_() % n; }

  void Put(uint64_t value, size_t size, size_t at, Bytes* bytes) {
    for (size_t i = 0; i < size && at + i < bytes->size(); ++i) {
      (*bytes)[at + i] = static_cast<uint8_t>(value >> (8 * (size - 1 - i)));
    }
  }

  void Change(size_t first, Bytes* bytes) {
    if (first >= bytes->size()) return;
    const size_t at = first + Below(bytes->size() - first);
    static const std::vector<uint32_t> kCounts = {
        0, 1, 2, 0x7fffffff, 0x80000000, 0xffffffff, 0x00ffffff, 1000, 65536};
    static const std::vector<double> kNumbers = {
        std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(),
        1e300,
        -1e300,
        5e-324,
        0.0};
    static const std::vector<int64_t> kTimes = {
        std::numeric_limits<int64_t>::min(),
        std::numeric_limits<int64_t>::max(), -1};
    switch (Below(5)) {
      case 0:
        (*bytes)[at] = static_cast<uint8_t>(random_());
        break;
      case 1:
        Put(kCounts[Below(kCounts.size())], 4, at, bytes);
        break;
      case 2:
        Put(std::bit_cast<uint64_t>(kNumbers[Below(kNumbers.size())]), 8, at,
            bytes);
        break;
      case 3:
        Put(std::bit_cast<uint64_t>(kTimes[Below(kTimes.size())]), 8, at,
            bytes);
        break;
      default:
        (*bytes)[at] ^= static_cast<uint8_t>(1u << Below(8));
    }
  }

  std::mt19937_64 random_;
  bool is_sly_ = false;
};

// Every service that takes the channel, alive on a Stepper of its own. (The
// recorder takes bytes as they are.)
class Targets {
 public:
  explicit Targets(const std::string& channel) : channel_(channel) {
    const Roster roster = TheRoster();
    for (const auto& [name, factory] :
         AllServices(kDeployment, "assembly", 1)) {
      const auto index = roster.IndexOf(name);
      if (!index || name == "recorder") continue;
      const Roster::Entry& entry = roster.entries[*index];
      auto stepper = std::make_unique<Stepper>(
          Stepper::Params{.name = name, .truth_role = entry.truth_role});
      auto service = factory(*stepper);
      if (stepper->Wants(channel)) {
        services_.push_back({std::move(stepper), std::move(service)});
        is_costly_ |= name == roster.entries[0].name ||
                      (name == "motion_planner" && channel == "MOTION_REQUEST");
      }
    }
    if (channel.starts_with("ARM_") || channel == "SKILL_RESULT") BeginRobot();
  }

  void Feed(const Bytes& bytes) {
    const auto message = MessageFromWire(channel_, bytes);
    if (!message) return;  // too short for a header: the bus drops it
    waiting_.push_back(*message);
    // What reaches the world costs a tick of its physics; a request, a search.
    const size_t batch = is_costly_ ? 200 : 1;
    if (waiting_.size() < batch) return;
    ++tick_;
    for (auto& [stepper, service] : services_) {
      if (stepper->Accept(tick_, waiting_) == Stepper::State::kReady) {
        stepper->Run();
      }
    }
    waiting_.clear();
  }

  size_t size() const { return services_.size(); }
  int64_t num_rejected() const {
    int64_t num = 0;
    for (const auto& [stepper, service] : services_) {
      for (const auto& [channel, count] : stepper->num_rejected()) num += count;
    }
    return num;
  }

 private:
  // Services act on the reports of arms in an episode of the robot only.
  void BeginRobot() {
    episode_t episode{};
    episode.goal = "assembled";
    episode.agent = "robot";
    const auto message = MessageFromWire("EPISODE", Bus::Encode(episode));
    ++tick_;
    for (auto& [stepper, service] : services_) {
      if (stepper->Wants("EPISODE")) stepper->Accept(tick_, {*message});
      stepper->Run();
    }
  }

  std::string channel_;
  bool is_costly_ = false;
  std::vector<std::pair<std::unique_ptr<Stepper>, std::unique_ptr<Service>>>
      services_;
  std::vector<Message> waiting_;
  int32_t tick_ = 0;
};

class ForgedMessages : public testing::TestWithParam<const char*> {};

TEST_P(ForgedMessages, CrashNoServiceAndAreCounted) {
  const std::string channel = GetParam();
  ASSERT_TRUE(Corpus().contains(channel));
  const std::vector<Bytes>& samples = Corpus().at(channel);
  Targets targets(channel);
  Forger forger(20260101);
  const int64_t before = UsageOfThisProcess().resident_bytes;
  for (int i = 0; i < kNumForgeries; ++i) {
    const Bytes forged =
        forger.Forge(samples[static_cast<size_t>(i) % samples.size()]);
    targets.Feed(forged);
    if (const auto message = MessageFromWire(channel, forged)) {
      Narrator().Describe(*message);
      EpisodeObserver().Put(*message);
      Decode<truth_contacts_t>(*message);
      Decode<status_t>(*message);
      Decode<relation_layers_t>(*message);
      if (const auto frame = Decode<rgbd_frame_t>(*message)) {
        FrameFromMessage(*frame);
      }
    }
  }
  EXPECT_LT(UsageOfThisProcess().resident_bytes - before, kMaxGrowth);
  if (targets.size() > 0) {
    EXPECT_GT(targets.num_rejected(), kNumForgeries / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllChannels, ForgedMessages,
    testing::Values("EPISODE", "COMMAND_EPISODE", "COMMAND_CONFIRM",
                    "COMMAND_FAULT", "TRUTH_POSES", "TRUTH_CONTACTS",
                    "TRUTH_ACTIONS", "TRACKS", "KEY_FRAME", "RELATION_LAYERS",
                    "ACTION", "PREDICATES", "PLAN", "ALERT", "ANSWER", "STATUS",
                    "COMMAND_GOAL", "COMMAND_MODE", "COMMAND_LIBRARY",
                    "COMMAND_NAME", "MOTION_PERMIT", "MOTION_PLAN",
                    "MOTION_REQUEST", "MODE", "SENSE_REQUEST", "SKILL_REQUEST",
                    "SKILL_RESULT", "EXECUTION", "ARM_REPORT_LEFT",
                    "ARM_REPORT_RIGHT", "ARM_STATE_LEFT", "ARM_STATE_RIGHT",
                    "WRENCH_RIGHT", "ARM_SETPOINT_LEFT", "ARM_SETPOINT_RIGHT",
                    "FRAME_1", "LIBRARY_REQUEST", "STORE_REQUEST", "EXPERIENCE",
                    "EXPERIENCE_REQUEST"),
    [](const auto& channel) { return std::string(channel.param); });

// The protocol's own messages, through both ends of it.
class ForgedProtocol {
 public:
  ForgedProtocol() : clock_(TheRoster(), 1) {
    for (const auto& entry : TheRoster().entries) {
      hello_t hello{};
      hello.name = entry.name;
      hello.nonce = 1;
      hello.types_digest = kTypesDigest;
      clock_.Hello(hello);
    }
    join_ = clock_.Advance({}, false);
    JoinNode();
  }

  void Feed(const Message& message) {
    if (const auto hello = Decode<hello_t>(message)) clock_.Hello(*hello);
    if (const auto ack = Decode<ack_t>(message)) {
      num_heeded_ += clock_.Ack(*ack);
    }
    Decode<health_t>(message);
    const auto tick = Decode<tick_t>(message);
    if (!tick) return;
    try {
      node_->PutTick(*tick);
      node_->Advance();
    } catch (const BusError&) {
      JoinNode();  // a second cell or incarnation; a real service would exit
    }
    if (node_->is_done()) JoinNode();
  }

  int num_heeded() const { return num_heeded_; }

 private:
  void JoinNode() {
    node_ = std::make_unique<LockstepNode>(
        TheRoster(), "recorder", 1,
        [](Bus&) { return std::make_unique<Service>(); },
        LockstepNode::Link{.send_data = [](const Message&) {},
                           .send_ack =
                               [](const ack_t&) {
                               }});
    node_->PutTick(join_);
    node_->Advance();
  }

  Clock clock_;
  tick_t join_{};
  std::unique_ptr<LockstepNode> node_;
  int num_heeded_ = 0;
};

TEST(ForgedMessages, OfTheProtocolCrashNeitherClockNorNode) {
  ForgedProtocol protocol;
  Forger forger(20260102);
  const int64_t before = UsageOfThisProcess().resident_bytes;
  for (const char* channel : {"HELLO", "ACK", "TICK", "HEALTH"}) {
    const std::vector<Bytes>& samples = Corpus().at(channel);
    for (int i = 0; i < kNumForgeries; ++i) {
      const Bytes forged =
          forger.Forge(samples[static_cast<size_t>(i) % samples.size()]);
      if (const auto message = MessageFromWire(channel, forged)) {
        protocol.Feed(*message);
      }
    }
  }
  EXPECT_LT(protocol.num_heeded(), kNumForgeries / 10);
  EXPECT_LT(UsageOfThisProcess().resident_bytes - before, kMaxGrowth);
}

}  // namespace
}  // namespace cell
