#include "common/bus/stepper.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "cell/status_t.hpp"
#include "common/bus/decode.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using toy::Number;

Message MessageOn(const std::string& channel, int32_t tick, int32_t sender,
                  int32_t seq, int64_t value) {
  Bytes bytes = Bus::Encode(Number(7, value));
  WriteIdentity(tick, sender, seq, bytes);
  return *MessageFromWire(channel, bytes);
}

TEST(Stepper, DeliversByChannelSenderAndSeqWhateverTheOrderOfArrival) {
  std::vector<int64_t> seen;
  const auto run = [&seen](std::vector<Message> inputs) {
    seen.clear();
    Stepper stepper({.name = "s"});
    for (const char* channel : {"B", "A"}) {
      stepper.Subscribe<status_t>(channel, [&seen](const status_t& m) {
        seen.push_back(m.counters[0].value);
      });
    }
    EXPECT_EQ(stepper.Accept(5, std::move(inputs)), Stepper::State::kReady);
    stepper.Run();
  };
  std::vector<Message> inputs = {
      MessageOn("B", 4, 1, 0, 4), MessageOn("A", 4, 2, 0, 3),
      MessageOn("A", 4, 1, 1, 2), MessageOn("A", 4, 1, 0, 1)};
  run(inputs);
  EXPECT_THAT(seen, ElementsAre(1, 2, 3, 4));
  std::reverse(inputs.begin(), inputs.end());
  run(inputs);
  EXPECT_THAT(seen, ElementsAre(1, 2, 3, 4));
}

TEST(Stepper, KeepsOnlyTheNewestOfAShallowChannel) {
  std::vector<int64_t> seen;
  Stepper stepper({.name = "s"});
  stepper.Subscribe<status_t>(
      "A", [&](const status_t& m) { seen.push_back(m.counters[0].value); }, 1);
  stepper.Accept(1, {MessageOn("A", 1, 0, 0, 1), MessageOn("A", 1, 0, 1, 2)});
  stepper.Run();
  EXPECT_THAT(seen, ElementsAre(2));
}

TEST(Stepper, StampsOutputsAndKeepsUtime) {
  Stepper stepper({.name = "s", .sender = 4, .status_phase = 61});
  stepper.Every(2, 1, [&] {
    stepper.Publish("OUT", Number(123, 9));
    stepper.Publish("OUT", Number(124, 9));
  });
  EXPECT_EQ(stepper.Accept(2, {}), Stepper::State::kIdle);
  ASSERT_EQ(stepper.Accept(3, {}), Stepper::State::kReady);
  const auto outputs = stepper.Run();
  ASSERT_EQ(outputs.size(), 2u);
  const WireHeader header = ReadWireHeader(*outputs[1].bytes);
  EXPECT_EQ(header.utime, 124);
  EXPECT_EQ(header.tick, 3);
  EXPECT_EQ(header.sender, 4);
  EXPECT_EQ(header.seq, 1);
  EXPECT_EQ(outputs[1].digest, DigestOf(*outputs[1].bytes));
}

TEST(Stepper, LetsInputsWaitForTheEndOfASlowActivation) {
  std::vector<int64_t> seen;
  Stepper stepper({.name = "s", .latency = 3, .status_phase = 61});
  stepper.Subscribe<status_t>("A", [&](const status_t& m) {
    seen.push_back(m.counters[0].value);
    stepper.Publish("OUT", m);
  });
  ASSERT_EQ(stepper.Accept(10, {MessageOn("A", 10, 0, 0, 1)}),
            Stepper::State::kReady);
  EXPECT_EQ(stepper.until(), 12);
  EXPECT_EQ(stepper.Run().at(0).tick, 12);
  EXPECT_EQ(stepper.Accept(11, {MessageOn("A", 11, 0, 1, 2)}),
            Stepper::State::kWaiting);
  EXPECT_EQ(stepper.Accept(12, {MessageOn("A", 12, 0, 2, 3)}),
            Stepper::State::kWaiting);
  ASSERT_EQ(stepper.Accept(13, {}), Stepper::State::kReady);
  EXPECT_EQ(stepper.Run().size(), 2u);
  EXPECT_THAT(seen, ElementsAre(1, 2, 3));
  EXPECT_EQ(stepper.Accept(16, {}), Stepper::State::kIdle);
}

TEST(Stepper, CountsWhatItCannotUseAndSaysSoInStatus) {
  Stepper stepper({.name = "s", .status_phase = 3});
  stepper.Subscribe<status_t>("A", [](const status_t&) {});
  Message bad = MessageOn("A", 3, 0, 0, 1);
  bad.bytes =
      std::make_shared<const Bytes>(bad.bytes->begin(), bad.bytes->end() - 1);
  stepper.Accept(3, {bad, MessageOn("A", 3, 0, 1, 1)});
  const auto outputs = stepper.Run();
  ASSERT_EQ(outputs.size(), 1u);
  status_t status{};
  ASSERT_GT(status.decode(outputs[0].bytes->data(), 0,
                          static_cast<int>(outputs[0].bytes->size())),
            0);
  ASSERT_EQ(status.num_counters, 2);
  EXPECT_EQ(status.counters[0].name, "handled:A");
  EXPECT_EQ(status.counters[0].value, 1);
  EXPECT_EQ(status.counters[1].name, "rejected:A");
  EXPECT_EQ(status.counters[1].value, 1);
}

TEST(Stepper, RejectsWhatWasMeasuredAtATimeThatNoRunHas) {
  Stepper stepper({.name = "s"});
  int num_seen = 0;
  stepper.Subscribe<status_t>("A", [&](const status_t&) { ++num_seen; });
  int32_t seq = 0;
  std::vector<Message> inputs;
  for (const int64_t utime :
       {std::numeric_limits<int64_t>::min(), int64_t{-1}, int64_t{0}, kMaxUtime,
        kMaxUtime + 1, std::numeric_limits<int64_t>::max()}) {
    Bytes bytes = Bus::Encode(Number(utime, 1));
    WriteIdentity(1, 0, seq++, bytes);
    inputs.push_back(*MessageFromWire("A", bytes));
  }
  stepper.Accept(1, inputs);
  stepper.Run();
  EXPECT_EQ(num_seen, 2);
  EXPECT_EQ(stepper.num_rejected().at("A"), 4);
}

TEST(Stepper, RefusesGroundTruthToEstimators) {
  const auto handler = [](const status_t&) {
  };
  Stepper estimator({.name = "planner"});
  EXPECT_THROW(estimator.Subscribe<status_t>("TRUTH_POSES", handler),
               std::logic_error);
  EXPECT_THROW(estimator.SubscribeAll([](const auto&, auto) {}),
               std::logic_error);
  Stepper ideal({.name = "tracker", .truth_role = "tracker_ideal"});
  EXPECT_NO_THROW(ideal.Subscribe<status_t>("TRUTH_POSES", handler));
}

TEST(Stepper, RefusesCallersMistakes) {
  Stepper stepper({.name = "s"});
  stepper.Subscribe<status_t>("A", [](const status_t&) {});
  EXPECT_THROW(stepper.Subscribe<status_t>("A", [](const status_t&) {}),
               std::logic_error);
  EXPECT_THROW(stepper.Publish("B", Number(0, 0)), std::logic_error);
  EXPECT_THROW(stepper.Every(0, 0, [] {}), std::logic_error);
  EXPECT_THROW(stepper.Every(5, 5, [] {}), std::logic_error);
  EXPECT_THROW(Stepper({.name = "s", .latency = 0}), std::logic_error);
}

}  // namespace
}  // namespace cell
