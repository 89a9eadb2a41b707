// What an arm asks of the planner of motions, and when it asks again.
#include "services/robot_arm/motion_client.h"

#include <gmock/gmock.h>

#include "services/robot_arm/motions.h"
#include "services/robot_arm/reachable_parts.h"
#include "tests/unit/motion_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using State = SkillStage::State;

MotionPlan Answer(const MotionRequest& request) {
  MotionPlan plan;
  plan.id = request.id;
  plan.arm = request.arm;
  return plan;
}

MotionPlan ClearanceColumn(const MotionRequest& request, double to) {
  MotionPlan plan = Answer(request);
  plan.waypoints = {Joints::Zero(), Joints::Constant(to)};
  return plan;
}

TEST(MotionClient, AnInquiryWaitsForItsOwnAnswer) {
  MotionClient client;
  MotionInquiry first(client, {}), second(client, {});
  const auto requests = client.TakeRequests();
  ASSERT_THAT(requests, SizeIs(2));
  EXPECT_TRUE(client.Put(Answer(requests[1])));
  EXPECT_EQ(first.Step(0.008), MotionInquiry::State::kWaiting);
  EXPECT_EQ(second.Step(0.008), MotionInquiry::State::kFound);
  MotionPlan unknown = Answer(requests[1]);
  unknown.id = 99;
  EXPECT_FALSE(client.Put(unknown));
}

TEST(MotionClient, ALostRequestIsAskedAgainAndGivenUpAtLastWithAReason) {
  MotionClient client;
  MotionInquiry inquiry(client, {});
  EXPECT_THAT(client.TakeRequests(), SizeIs(1));
  size_t num_repeats = 0;
  double time = 0;
  while (inquiry.Step(0.1) == MotionInquiry::State::kWaiting && time < 100) {
    num_repeats += client.TakeRequests().size();
    time += 0.1;
  }
  EXPECT_NEAR(time, 20, 0.2);
  EXPECT_NEAR(static_cast<double>(num_repeats), 20, 2);
  EXPECT_FALSE(inquiry.is_answered());
  EXPECT_THAT(inquiry.reason(), HasSubstr("the motion planner has not"));
}

TEST(MotionClient, AnAbandonedRequestIsNotAwaited) {
  MotionClient client;
  auto inquiry = std::make_unique<MotionInquiry>(client, MotionRequest{});
  const auto requests = client.TakeRequests();
  inquiry.reset();
  EXPECT_FALSE(client.Put(Answer(requests[0])));
}

TEST(FollowWay, StandsUntilThereIsAWayThenFollowsIt) {
  MotionClient client;
  FollowWay stage(client, {}, {1.0, 2.5});
  ArmReading reading;
  ArmCommand command;
  EXPECT_EQ(stage.Step(reading, 0.008, &command), State::kWaiting);
  EXPECT_FALSE(stage.HasOtherWays());
  EXPECT_FALSE(stage.Ahead(0.3, command.q));
  client.Put(ClearanceColumn(client.TakeRequests().at(0), 0.2));
  State state = State::kWaiting;
  for (int i = 0; i < 500; ++i) {
    state = stage.Step(reading, 0.008, &command);
    reading.q = command.q;
    if (state == State::kDone) break;
    EXPECT_EQ(state, State::kRunning);
    EXPECT_TRUE(stage.HasOtherWays());
  }
  EXPECT_EQ(state, State::kDone);
  EXPECT_EQ(command.q, Joints::Constant(0.2));
}

TEST(FollowWay, FailsWithTheReasonOfTheAnswer) {
  MotionClient client;
  FollowWay stage(client, {}, {1.0, 2.5});
  MotionPlan none = Answer(client.TakeRequests().at(0));
  none.reason = "the table is in the way";
  client.Put(none);
  ArmCommand command;
  EXPECT_EQ(stage.Step({}, 0.008, &command), State::kFailed);
  EXPECT_EQ(stage.failure().reason, "the table is in the way");
}

class ReachingParts : public testing::Test {
 protected:
  ReachingParts() {
    for (const char* part : {"shaft", "head"}) Put(part, 0.1);
    Observe();
  }
  void Put(const std::string& part, double y) {
    cell_.poses[part] = cell_.Standing(part, part == "head" ? 0.3 : 0, -y);
  }
  void Observe() {
    monitor_.SetParts(cell_.poses);
    parts_.Update(cell_.poses);
  }
  /// The parts that it asks about in this tick.
  std::vector<std::string> Asked() {
    parts_.Step(0.008);
    const auto requests = client_.TakeRequests();
    if (requests.empty()) return {};
    last_ = requests.front();
    return last_.wanted;
  }
  void Answer(const std::vector<std::string>& reachable) {
    MotionPlan plan = cell::Answer(last_);
    plan.reachable = reachable;
    client_.Put(plan);
    parts_.Step(0.008);
  }

  ShippedMotions cell_;
  SceneMonitor monitor_{
      {"right", cell_.task.layout, cell_.task.parts, 0.008, {}}};
  MotionClient client_;
  ReachableParts parts_{cell_.task.parts, monitor_, client_};
  MotionRequest last_;
};

TEST_F(ReachingParts, AreAskedAboutTogetherAndOnce) {
  EXPECT_THAT(Asked(), ElementsAre("head", "shaft"));  // not what is fixed
  EXPECT_THAT(Asked(), IsEmpty());
  Answer({"shaft"});
  EXPECT_THAT(parts_.List(), ElementsAre("shaft"));
  Observe();
  EXPECT_THAT(Asked(), IsEmpty());
}

TEST_F(ReachingParts, AreAskedAboutAgainWhereTheyComeToRest) {
  Asked();
  Answer({"shaft"});
  Put("shaft", 0.2);
  Observe();
  EXPECT_THAT(Asked(), IsEmpty());  // it moves
  Observe();
  EXPECT_THAT(Asked(), ElementsAre("shaft"));
  EXPECT_THAT(parts_.List(), ElementsAre("shaft"));
  Answer({});
  EXPECT_THAT(parts_.List(), IsEmpty());
}

TEST_F(ReachingParts, InAPersonsHandAreNotAmongThem) {
  Asked();
  Answer({"head", "shaft"});
  monitor_.SetHands({cell_.poses.at("shaft").translation()});
  EXPECT_THAT(parts_.List(), ElementsAre("head"));
}

}  // namespace
}  // namespace cell
