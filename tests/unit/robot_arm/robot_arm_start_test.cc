// What a robot_arm refuses to start with.
#include <gmock/gmock.h>

#include "cell/alert_t.hpp"
#include "common/bus/stepper.h"
#include "common/config/config.h"
#include "common/kinematics/joint_values.h"
#include "services/robot_arm/robot_arm.h"
#include "tests/unit/changed_deployment.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

/// The shipped cell, which a test may change.
class RobotArmStart : public testing::Test {
 protected:
  void Change(const std::string& from, const std::string& to) const {
    deployment_.Change("cell.yaml", from, to);
  }
  /// Nothing if it starts.
  std::string WhyRefused(const std::string& arm) const {
    Stepper stepper(Stepper::Params{.name = "robot_arm@" + arm});
    try {
      MakeRobotArm(stepper, deployment_.get(), arm);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  ChangedDeployment deployment_{ShippedDeployment()};
};

TEST_F(RobotArmStart, TheShippedCellIsAccepted) {
  EXPECT_EQ(WhyRefused("left"), "");
  EXPECT_EQ(WhyRefused("right"), "");
}

TEST_F(RobotArmStart, ACellWhoseArmsCollideAtHomeIsRefusedByFileAndKey) {
  Change("xyz: [-0.40, 0.00", "xyz: [0.40, 0.00");
  EXPECT_THAT(WhyRefused("right"),
              testing::ContainsRegex("cell.yaml:arms.left.home: .*_left.* "
                                     "would hit .*_right.*"));
}

TEST_F(RobotArmStart, AnArmThatTheCellDoesNotHaveIsRefused) {
  EXPECT_THAT(WhyRefused("third"),
              testing::HasSubstr("cell.yaml:arms: there is no arm 'third'"));
}

TEST_F(RobotArmStart, AHomeOutOfTheModelsReachIsRefusedByFileAndKey) {
  Change("right:\n    model: ur5", "right:\n    model: ur3e");
  EXPECT_THAT(WhyRefused("left"),
              testing::HasSubstr("cell.yaml:arms.right.home"
                                 ": out of reach of a ur3e"));
}

/// The right arm's service in a cell whose right arm is a UR10e, whose first
/// joint turns by 120 deg/s, and whose left arm is a UR5, by 180.
class RobotArmBesideAnotherModel : public RobotArmStart {
 protected:
  RobotArmBesideAnotherModel() {
    Change("right:\n    model: ur5", "right:\n    model: ur10e");
    service_ = MakeRobotArm(stepper_, deployment_.get(), "right");
  }

  // Of an arm at home whose first joint turns at `speed` [rad/s].
  arm_state_t StateOf(const std::string& arm, double speed) const {
    const CellLayout layout =
        CellLayout::FromConfig(deployment_.get().OfTask("cell.yaml"));
    arm_state_t state{};
    ToMessage(layout.FindArm(arm)->home, &state.num_joints, &state.position);
    ToMessage(speed * Joints::Unit(0), &state.num_joints, &state.velocity);
    return state;
  }
  void Put(const std::string& channel, const arm_state_t& state) {
    const Message message{
        .channel = channel,
        .tick = tick_,
        .seq = seq_++,
        .bytes = std::make_shared<const Bytes>(Bus::Encode(state))};
    ASSERT_EQ(stepper_.Accept(tick_++, {message}), Stepper::State::kReady);
    for (const Message& output : stepper_.Run()) {
      if (output.channel != "ALERT") continue;
      alerts_.push_back(Decode<alert_t>(output)->text);
    }
  }

  Stepper stepper_{Stepper::Params{.name = "robot_arm@right"}};
  std::unique_ptr<Service> service_;
  std::vector<std::string> alerts_;
  int32_t tick_ = 0, seq_ = 0;
};

TEST_F(RobotArmBesideAnotherModel, EachArmsStateIsHeldAgainstItsOwnLimits) {
  constexpr double kSpeed = 5;  // [rad/s] 2 x 120 deg/s < it < 2 x 180 deg/s
  Put("ARM_STATE_LEFT", StateOf("left", kSpeed));
  EXPECT_THAT(alerts_, testing::IsEmpty());
  Put("ARM_STATE_RIGHT", StateOf("right", kSpeed));
  EXPECT_THAT(alerts_, testing::ElementsAre(
                           "ARM_STATE_RIGHT is rejected: faster than twice the "
                           "speed of a ur10e"));
  EXPECT_EQ(stepper_.num_rejected().size(), 1u);
}

TEST_F(RobotArmBesideAnotherModel, JointsOfAnotherNumberAreReportedOnce) {
  arm_state_t state = StateOf("left", 0);
  state.position.push_back(0);
  state.velocity.push_back(0);
  state.num_joints = 7;
  Put("ARM_STATE_LEFT", state);
  Put("ARM_STATE_LEFT", state);
  EXPECT_THAT(alerts_,
              testing::ElementsAre("ARM_STATE_LEFT is rejected: 7 joints "
                                   "instead of the 6 of a ur5"));
  EXPECT_EQ(stepper_.num_rejected().at("ARM_STATE_LEFT"), 2);
}

}  // namespace
}  // namespace cell
