// The service that plans, on a stepper of its own.
#include "services/motion_planner/motion_planner.h"

#include <gmock/gmock.h>

#include "common/bus/stepper.h"
#include "tests/unit/motion_testing.h"

namespace cell {
namespace {

class MotionPlanning : public testing::Test {
 protected:
  MotionPlanning() {
    cell_.poses["shaft"] = cell_.Standing("shaft", 0.1, -0.4);
  }
  Message Asking(const MotionRequest& request) {
    Bytes bytes = Bus::Encode(ToMessage(request));
    WriteIdentity(1, 6, seq_++, bytes);
    return *MessageFromWire("MOTION_REQUEST", bytes);
  }
  std::vector<motion_plan_t> Answers(const std::vector<Message>& inputs) {
    Stepper stepper({.name = "motion_planner", .latency = 3});
    const auto service =
        motion_planner::MakeMotionPlanner(stepper, ShippedDeployment());
    EXPECT_EQ(stepper.Accept(2, inputs), Stepper::State::kReady);
    std::vector<motion_plan_t> plans;
    for (const Message& message : stepper.Run()) {
      if (message.channel != "MOTION_PLAN") continue;
      EXPECT_EQ(message.tick, 4);  // its latency
      plans.push_back(Decode<motion_plan_t>(message).value());
    }
    return plans;
  }

  ShippedMotions cell_;
  int32_t seq_ = 0;
};

TEST_F(MotionPlanning, AnswersEachArm) {
  std::vector<Message> inputs;
  for (const char* arm : {"left", "right"}) {
    MotionRequest request = cell_.TakeRequest("shaft", arm);
    request.id = 40 + static_cast<int64_t>(inputs.size());
    inputs.push_back(Asking(request));
  }
  const auto plans = Answers(inputs);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].arm, "left");
  EXPECT_EQ(plans[0].id, 40);
  EXPECT_EQ(plans[1].id, 41);
  EXPECT_TRUE(plans[1].is_found) << plans[1].reason;
}

TEST_F(MotionPlanning, AnswersTheNewestOfAnArmAndItsReachApart) {
  MotionRequest request = cell_.TakeRequest("shaft", "right");
  std::vector<Message> inputs;
  for (const int64_t id : {1, 2, 3}) {
    request.id = id;
    request.kind =
        id == 2 ? MotionRequest::Kind::kReach : MotionRequest::Kind::kGrasp;
    request.wanted = {"shaft"};
    inputs.push_back(Asking(request));
  }
  const auto plans = Answers(inputs);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].id, 3);
  EXPECT_EQ(plans[1].id, 2);
  EXPECT_THAT(plans[1].reachable, testing::ElementsAre("shaft"));
}

}  // namespace
}  // namespace cell
