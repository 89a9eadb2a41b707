// What a robot_arm refuses to start with.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/bus/stepper.h"
#include "common/config/config.h"
#include "services/robot_arm/robot_arm.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

/// The shipped deployment with a task folder that a test may change.
class RobotArmStart : public testing::Test {
 protected:
  RobotArmStart() {
    deployment_.task_dir =
        std::filesystem::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::copy(ShippedDeployment().task_dir, deployment_.task_dir,
                          std::filesystem::copy_options::recursive);
  }
  ~RobotArmStart() override {
    std::filesystem::remove_all(deployment_.task_dir);
  }

  void Change(const std::string& from, const std::string& to) const {
    const std::filesystem::path path = deployment_.task_dir / "cell.yaml";
    std::stringstream stream;
    stream << std::ifstream(path).rdbuf();
    std::string text = stream.str();
    text.replace(text.find(from), from.size(), to);
    std::ofstream(path) << text;
  }
  /// Nothing if it starts.
  std::string WhyRefused(const std::string& arm) const {
    Stepper stepper(Stepper::Params{.name = "robot_arm@" + arm});
    try {
      MakeRobotArm(stepper, deployment_, arm);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  Deployment deployment_ = ShippedDeployment();
};

TEST_F(RobotArmStart, TheShippedCellIsAccepted) {
  EXPECT_EQ(WhyRefused("left"), "");
  EXPECT_EQ(WhyRefused("right"), "");
}

TEST_F(RobotArmStart, ACellWhoseArmsCollideAtHomeIsRefusedByFileAndKey) {
  Change("xyz: [0.50, -0.05, 0.10]", "xyz: [-0.25, 0.30, 0.10]");
  EXPECT_THAT(WhyRefused("right"),
              testing::ContainsRegex("cell.yaml:arms.left.home_deg: .*_left.* "
                                     "would hit .*_right.*"));
}

TEST_F(RobotArmStart, AnArmThatTheCellDoesNotHaveIsRefused) {
  EXPECT_THAT(WhyRefused("third"),
              testing::HasSubstr("cell.yaml:arms: there is no arm 'third'"));
}

}  // namespace
}  // namespace cell
