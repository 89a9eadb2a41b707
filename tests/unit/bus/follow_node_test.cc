// A service behind the log of a toy cell's run, as lcm-logplayer plays it.
#include "common/bus/follow_node.h"

#include <gmock/gmock.h>

#include "common/bus/sim_bus.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

using testing::HasSubstr;
using toy::ToyFactories;
using toy::ToyRoster;

constexpr int32_t kNumFollowed = 60;

struct Follower {
  explicit Follower(const std::string& name)
      : node(ToyRoster(), name, ToyFactories(kNumFollowed).at(name),
             [this](const Message& m) { sent.push_back(m); }) {}
  std::vector<Message> sent;
  FollowNode node;
};

// Plays a run without the channels that followers are to publish; outputs of
// one follower reach the others.
void Play(
    const std::vector<Follower*>& followers,
    const std::set<std::string>& left_out,
    const std::function<void(Message*)>& change = [](Message*) {}) {
  SimBus bus(ToyRoster(), ToyFactories(kNumFollowed));
  const auto hear = [&](const Message& message) {
    for (Follower* follower : followers) {
      if (follower->node.Wants(message.channel)) {
        follower->node.PutData(message);
      }
    }
  };
  while (bus.Step()) {
    for (Message message : bus.last_messages()) {
      if (left_out.contains(message.channel)) continue;
      change(&message);
      hear(message);
    }
    for (Follower* follower : followers) {
      follower->node.PutTick(bus.last_tick());
      while (follower->node.Advance()) {
      }
      for (const Message& m : std::exchange(follower->sent, {})) hear(m);
    }
  }
}

TEST(FollowNode, PublishesWhatTheRecordedServiceDid) {
  Follower first("first");
  Play({&first}, {});
  EXPECT_TRUE(first.node.is_done());
  EXPECT_EQ(first.node.difference(), std::nullopt);
  EXPECT_GT(first.node.num_equal(), 60);
}

TEST(FollowNode, AChainOfFollowersNeedsOnlyItsFirstInputs) {
  Follower first("first"), second("second"), third("third");
  Play({&first, &second, &third}, {"DOUBLE", "SUM", "ECHO"});
  for (const Follower* follower : {&first, &second, &third}) {
    EXPECT_TRUE(follower->node.is_done()) << *follower->node.MissingData();
    EXPECT_EQ(follower->node.difference(), std::nullopt);
    EXPECT_GT(follower->node.num_equal(), 20);
  }
}

TEST(FollowNode, NamesAMessageThatThePlayerLost) {
  Follower first("first");
  Play({&first}, {"SOURCE"});
  EXPECT_FALSE(first.node.is_done());
  EXPECT_THAT(*first.node.MissingData(), HasSubstr("SOURCE sender 0 seq 0"));
}

TEST(FollowNode, SaysWhereItDiffersFromTheLog) {
  // Another service under the recorded one's name.
  Follower other("first");
  FollowNode node(ToyRoster(), "first", ToyFactories(kNumFollowed).at("third"),
                  [](const Message&) {});
  SimBus bus(ToyRoster(), ToyFactories(kNumFollowed));
  while (bus.Step()) {
    for (const Message& m : bus.last_messages()) node.PutData(m);
    node.PutTick(bus.last_tick());
    while (node.Advance()) {
    }
  }
  EXPECT_THAT(*node.difference(), HasSubstr("tick 1:"));
}

}  // namespace
}  // namespace cell
