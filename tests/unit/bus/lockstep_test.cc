// The protocol of Clock and LockstepNode against SimBus, with a wire between
// them that loses, doubles and shuffles datagrams.
#include <gmock/gmock.h>

#include <random>

#include "common/bus/bus_error.h"
#include "common/bus/clock.h"
#include "common/bus/lockstep_node.h"
#include "common/bus/manifest.h"
#include "common/bus/sim_bus.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

using toy::ToyFactories;
using toy::ToyRoster;

constexpr int32_t kNumTicks = 60;

// The source reads what "second" says only.
Roster FeedingRoster(const std::string& feeder = "second") {
  Roster roster = ToyRoster();
  roster.entries[roster.RequireIndexOf(feeder)].feeds_clock = true;
  return roster;
}

std::vector<int64_t> RunSim(std::vector<SimBus::Outage> outages = {},
                            std::vector<SimBus::TimedCommand> commands = {}) {
  SimBus bus(ToyRoster(), ToyFactories(kNumTicks), std::move(outages),
             std::move(commands));
  std::vector<int64_t> digests;
  while (bus.Step()) digests.push_back(TickMessage(bus.last_tick()).digest);
  return digests;
}

struct WireFaults {
  double lost_tick = 0;
  double lost_ack = 0;
  double doubled = 0;
  bool is_shuffled = false;
  bool forges = false;
};

// Nodes and clock joined by a wire in memory.
class Wire {
 public:
  Wire(uint64_t seed, WireFaults faults, Roster roster = ToyRoster())
      : faults_(faults),
        random_(seed),
        roster_(std::move(roster)),
        factories_(ToyFactories(kNumTicks)),
        host_(roster_, factories_.at("source")),
        clock_(roster_, 77) {
    for (const char* name : {"first", "second", "third"}) Start(name);
  }

  void Start(const std::string& name) {
    nodes_[name] = std::make_unique<LockstepNode>(
        roster_, name, ++next_nonce_, factories_.at(name),
        LockstepNode::Link{
            .send_data = [this](const Message& m) { data_.push_back(m); },
            .send_ack =
                [this](const ack_t& a) {
                  acks_.push_back(a);
                }});
    EXPECT_EQ(clock_.Hello(nodes_[name]->Hello()), std::nullopt);
  }

  // Runs to the end; calls `between` after each TICK went out.
  template <class Between>
  std::vector<int64_t> Run(Between between) {
    std::vector<int64_t> digests;
    while (digests.empty() || !last_) {
      const int32_t tick = clock_.tick() + 1;
      AwaitAcks(Clock::Before::kActing);
      num_early_ += clock_.IsAwaiting(Clock::Before::kTick);
      const auto ids = MessagesIn(
          clock_.CurrentFlows(),
          [&](const std::string& channel) { return host_.Wants(channel); });
      auto inputs = clock_inbox_.Pop(ids);
      EXPECT_TRUE(inputs) << "tick " << tick;
      const auto own = host_.Tick(tick, *inputs, {});
      AwaitAcks(Clock::Before::kTick);
      last_ = host_.IsLast(tick);
      const tick_t manifest = clock_.Advance(own, last_);
      digests.push_back(TickMessage(manifest).digest);
      for (const Message& m : own) data_.push_back(m);
      if (!Chance(faults_.lost_tick)) SendTick(manifest);
      between(*this, tick);
    }
    AwaitAcks(Clock::Before::kTick);
    return digests;
  }
  std::vector<int64_t> Run() {
    return Run([](Wire&, int32_t) {});
  }
  /// Ticks in which the clock's service acted before all had answered.
  int num_early() const { return num_early_; }

 private:
  // Services answer one after the other, in a random order.
  void AwaitAcks(Clock::Before what) {
    for (int round = 0; clock_.IsAwaiting(what); ++round) {
      if (round % 8 == 7) {
        for (const tick_t& again : clock_.TicksToRepeat()) SendTick(again);
      }
      if (round == 8000) throw std::runtime_error("no end");
      Pump();
    }
  }
  bool Chance(double p) {
    return std::uniform_real_distribution<>(0, 1)(random_) < p;
  }
  void SendTick(const tick_t& tick) {
    for (auto& [name, node] : nodes_) {
      if (!Chance(faults_.lost_tick)) node->PutTick(tick);
    }
  }
  void Pump() {
    if (faults_.is_shuffled) std::shuffle(data_.begin(), data_.end(), random_);
    for (const Message& m : std::exchange(data_, {})) {
      if (faults_.forges) Deliver(ForgeryOf(m));
      Deliver(m);
      if (Chance(faults_.doubled)) Deliver(m);
    }
    auto node = nodes_.begin();
    std::advance(node, random_() % nodes_.size());
    while (node->second->Advance()) {
    }
    for (const ack_t& ack : std::exchange(acks_, {})) {
      if (Chance(faults_.lost_ack)) continue;
      clock_.Ack(ack);
      if (Chance(faults_.doubled)) clock_.Ack(ack);
    }
    // Data of this round must be there before the clock goes on.
    for (const Message& m : std::exchange(data_, {})) Deliver(m);
  }
  void Deliver(const Message& m) {
    if (host_.Wants(m.channel)) clock_inbox_.Put(m);
    for (auto& [name, node] : nodes_) {
      if (node->Wants(m.channel)) node->PutData(m);
    }
  }
  static Message ForgeryOf(const Message& m) {
    Bytes bytes = *m.bytes;
    bytes.back() ^= 1;
    return *MessageFromWire(m.channel, bytes);
  }

  WireFaults faults_;
  std::mt19937_64 random_;
  Roster roster_;
  std::map<std::string, ServiceFactory> factories_;
  ClockHost host_;
  Clock clock_;
  Inbox clock_inbox_;
  std::map<std::string, std::unique_ptr<LockstepNode>> nodes_;
  std::vector<Message> data_;
  std::vector<ack_t> acks_;
  int64_t next_nonce_ = 100;
  int num_early_ = 0;
  bool last_ = false;
};

TEST(Lockstep, GivesTheSameTicksAsOneProcess) {
  const auto expected = RunSim();
  EXPECT_EQ(expected.size(), static_cast<size_t>(kNumTicks + 2));
  EXPECT_EQ(Wire(1, {}).Run(), expected);
}

TEST(Lockstep, GivesTheSameInSpiteOfLossDuplicatesDisorderAndForgery) {
  const auto expected = RunSim();
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Wire wire(seed, {.lost_tick = 0.2,
                     .lost_ack = 0.2,
                     .doubled = 0.2,
                     .is_shuffled = true,
                     .forges = true});
    EXPECT_EQ(wire.Run(), expected) << "seed " << seed;
  }
}

TEST(Lockstep, TheClockActsBeforeThoseThatDoNotFeedItAnswer) {
  const auto expected = RunSim();
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Wire wire(seed,
              {.lost_tick = 0.2,
               .lost_ack = 0.2,
               .doubled = 0.2,
               .is_shuffled = true,
               .forges = true},
              FeedingRoster());
    EXPECT_EQ(wire.Run(), expected) << "seed " << seed;
    EXPECT_GT(wire.num_early(), kNumTicks / 4);
    Wire patient(seed, {});
    EXPECT_EQ(patient.Run(), expected);
    EXPECT_EQ(patient.num_early(), 0) << "where all feed it";
  }
}

TEST(Lockstep, AnUndeclaredFeederOfTheClockIsNamed) {
  SimBus bus(FeedingRoster("third"), ToyFactories(kNumTicks));
  try {
    while (bus.Step()) {
    }
    FAIL() << "second was not noticed";
  } catch (const BusError& e) {
    EXPECT_THAT(e.what(),
                testing::AllOf(testing::HasSubstr("second publishes SUM"),
                               testing::HasSubstr("feeds_clock: true")));
  }
}

TEST(Lockstep, ARestartedServiceEqualsTheSameOutageInOneProcess) {
  for (const std::string name : {"first", "second", "third"}) {
    // Consecutive ticks, so that a consumer dies in each phase of a slow one.
    for (const int32_t death : {1, 17, 30, 31, 32, 33}) {
      for (const Roster& roster : {ToyRoster(), FeedingRoster()}) {
        Wire wire(3, {}, roster);
        const auto digests = wire.Run([&](Wire& w, int32_t tick) {
          if (tick == death) w.Start(name);
        });
        // A slow service that was busy dies with its whole activation.
        bool is_found = false;
        for (int32_t d = death; d > death - 3 && d > 0 && !is_found; --d) {
          is_found = digests == RunSim({{name, d, death + 1}});
        }
        EXPECT_TRUE(is_found) << name << " dead at " << death;
      }
    }
  }
}

TEST(Lockstep, CommandsArriveInTheirTick) {
  const auto with =
      RunSim({}, {{10, {"COMMAND_ADD", Bus::Encode(toy::Number(0, 5))}}});
  const auto without = RunSim();
  EXPECT_TRUE(std::equal(with.begin(), with.begin() + 10, without.begin()));
  EXPECT_NE(with[10], without[10]);
}

TEST(Lockstep, RefusesUnknownServicesOldIncarnationsAndOtherTypes) {
  Clock clock(ToyRoster(), 1);
  hello_t hello{};
  hello.name = "nobody";
  EXPECT_THAT(*clock.Hello(hello), testing::HasSubstr("'nobody'"));
  hello.name = "source";
  EXPECT_THAT(*clock.Hello(hello), testing::HasSubstr("another cell"));
  hello.name = "first";
  EXPECT_THAT(*clock.Hello(hello), testing::HasSubstr("message types"));
  ack_t ack{};
  ack.run = 2;
  ack.header.sender = 1;
  EXPECT_FALSE(clock.Ack(ack));
}

// The toy service "first", whose outputs reach no other.
LockstepNode MuteNode(int64_t nonce) {
  return {ToyRoster(),
          "first",
          nonce,
          ToyFactories(9).at("first"),
          {.send_data = [](const Message&) {},
           .send_ack =
               [](const ack_t&) {
               }}};
}

tick_t TickOfJoining(int64_t nonce) {
  tick_t tick{};
  tick.run = 1;
  tick.num_joined = 1;
  tick.joined.resize(1);
  tick.joined[0].name = "first";
  tick.joined[0].nonce = nonce;
  return tick;
}

TEST(Lockstep, NamesTheMessageThatIsMissing) {
  LockstepNode node = MuteNode(5);
  tick_t tick = TickOfJoining(5);
  node.PutTick(tick);
  EXPECT_TRUE(node.Advance());
  tick.joined.clear();
  tick.num_joined = 0;
  tick.header.tick = 1;
  flow_t flow{};
  flow.channel = "SOURCE";
  flow.first_seq = 20;
  flow.count = 1;
  flow.digests = {42};
  tick.flows = {flow};
  tick.num_flows = 1;
  node.PutTick(tick);
  EXPECT_FALSE(node.Advance());
  EXPECT_THAT(*node.MissingData(),
              testing::AllOf(testing::HasSubstr("LOST first: tick 1"),
                             testing::HasSubstr("SOURCE sender 0 seq 20")));
}

TEST(Lockstep, DetectsASecondCellAndASecondIncarnation) {
  LockstepNode node = MuteNode(5);
  tick_t tick = TickOfJoining(5);
  node.PutTick(tick);
  tick_t other = tick;
  other.run = 2;
  EXPECT_THROW(node.PutTick(other), BusError);
  tick.joined[0].nonce = 6;
  EXPECT_THROW(node.PutTick(tick), BusError);
}

}  // namespace
}  // namespace cell
