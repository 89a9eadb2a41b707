// Which requests and plans are accepted.
#include "common/arms/motion_messages.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "tests/unit/motion_testing.h"

namespace cell {
namespace {

using Kind = MotionRequest::Kind;

class MotionMessages : public testing::Test {
 protected:
  MotionMessages() {
    cell_.poses["shaft"] = cell_.Standing("shaft", 0.1, -0.4);
    request_ = cell_.TakeRequest("shaft", "right");
    request_.arms["left"] = {HomePosture(cell_.Arm("left")), std::nullopt};
    plan_ = cell_.search.Find(request_);
  }
  // Empty if it is taken.
  std::string WhyNot(
      const std::function<void(motion_request_t&)>& change) const {
    motion_request_t message = ToMessage(request_);
    change(message);
    return FromMessage(message, cell_.task.parts, cell_.task.layout).reason();
  }
  bool IsTaken(const std::function<void(motion_request_t&)>& change) const {
    return WhyNot(change).empty();
  }
  std::string WhyNoPlan(
      const std::function<void(motion_plan_t&)>& change) const {
    motion_plan_t message = ToMessage(plan_, 7);
    change(message);
    return FromMessage(message, cell_.task.layout).reason();
  }
  bool IsPlan(const std::function<void(motion_plan_t&)>& change) const {
    return WhyNoPlan(change).empty();
  }

  ShippedMotions cell_;
  MotionRequest request_;
  MotionPlan plan_;
};

TEST_F(MotionMessages, ARequestArrivesAsItWas) {
  request_.kind = Kind::kGrasp;
  request_.target =
      PlaceTarget{cell_.poses.at("shaft"), Eigen::Vector3d::UnitX(), 0.12, -3};
  const auto request =
      FromMessage(ToMessage(request_), cell_.task.parts, cell_.task.layout);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->part, "shaft");
  EXPECT_EQ(request->arms.size(), 2u);
  EXPECT_EQ(request->arms.at("right").posture.q, cell_.Arm("right").home);
  EXPECT_TRUE(request->parts.at("shaft").isApprox(cell_.poses.at("shaft")));
  ASSERT_TRUE(request->target);
  EXPECT_EQ(request->target->way_out, Eigen::Vector3d::UnitX());
  EXPECT_EQ(request->target->turn, -3);
}

TEST_F(MotionMessages, ARequestThatMakesNoSenseIsRejected) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using M = motion_request_t;
  EXPECT_TRUE(IsTaken([](M&) {}));
  EXPECT_FALSE(IsTaken([](M& m) { m.arm = "third"; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.kind = 5; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.kind = -1; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.part = "nothing"; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.part = "base"; }));    // it is fixed
  EXPECT_FALSE(IsTaken([](M& m) { m.part = "head"; }));    // not seen
  EXPECT_FALSE(IsTaken([](M& m) { m.kind = M::PLACE; }));  // of nothing
  EXPECT_FALSE(IsTaken([](M& m) { m.kind = M::SET_DOWN; }));
  EXPECT_FALSE(IsTaken([](M& m) {
    m.kind = M::REACH;
    m.wanted = {"head"};
  }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms.pop_back(); }));  // the one to move
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[1] = m.arms[0]; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[0].grip = "pliers"; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[0].opening = -0.01; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[0].held = "base"; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[0].position[2] = 7; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.arms[0].position.pop_back(); }));
  EXPECT_FALSE(IsTaken([=](M& m) { m.goal[0] = nan; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.parts[0].name = "cup"; }));
  EXPECT_FALSE(IsTaken([](M& m) { m.parts[1] = m.parts[0]; }));
  EXPECT_FALSE(
      IsTaken([=](M& m) { m.parts[0].pose_world_body.position[0] = nan; }));
  EXPECT_FALSE(IsTaken([=](M& m) { m.area_max[1] = nan; }));
}

TEST_F(MotionMessages, JointsOfAnotherNumberThanTheArmsAreRejectedWithIt) {
  EXPECT_EQ(WhyNot([](auto& m) { m.goal.push_back(0); }),
            "its goal: 7 joints instead of the 6 of a ur5");
  EXPECT_EQ(WhyNot([](auto& m) { m.arms[0].position.clear(); }),
            "left: 0 joints instead of the 6 of a ur5");
  EXPECT_EQ(WhyNoPlan([](auto& m) { m.waypoints[0].position.pop_back(); }),
            "a waypoint: 5 joints instead of the 6 of a ur5");
}

TEST_F(MotionMessages, AnAreaTooLargeToBeSearchedIsRejected) {
  using M = motion_request_t;
  const auto set_down = [](double side) {
    return [side](M& m) {
      m.kind = M::SET_DOWN;
      for (arm_posture_t& arm : m.arms) {
        if (arm.arm == "right") arm.held = "shaft";
      }
      for (double& value : m.area_max) value = side;
    };
  };
  EXPECT_TRUE(IsTaken(set_down(0.5)));
  EXPECT_FALSE(IsTaken(set_down(3)));
  EXPECT_FALSE(IsTaken(set_down(-0.1)));
}

TEST_F(MotionMessages, APlanThatMakesNoSenseIsRejected) {
  using M = motion_plan_t;
  ASSERT_TRUE(plan_) << plan_.reason;
  EXPECT_TRUE(IsPlan([](M&) {}));
  EXPECT_FALSE(IsPlan([](M& m) { m.arm = "third"; }));
  EXPECT_FALSE(IsPlan([](M& m) { m.is_found = false; }));
  EXPECT_FALSE(IsPlan([](M& m) { m.reason = "no way"; }));
  EXPECT_FALSE(IsPlan([](M& m) { m.grip = "pliers"; }));
  EXPECT_FALSE(IsPlan([](M& m) { m.waypoints[0].position[0] = 9; }));
  EXPECT_FALSE(IsPlan([](M& m) { m.waypoints[0].position.push_back(0); }));
  EXPECT_FALSE(IsPlan([](M& m) { m.target.way_out[0] = 2; }));
  EXPECT_TRUE(IsPlan([](M& m) {
    m.is_found = false;
    m.reason = "no way";
  }));
}

}  // namespace
}  // namespace cell
