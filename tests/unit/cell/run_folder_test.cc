#include "services/cell/running/run_folder.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "common/files/temporary_folder.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

class RunFolderTest : public testing::Test {
 protected:
  YAML::Node ConfigOf(const std::string& service) const {
    return YAML::LoadFile(run_.deployment.config_dir / (service + ".yaml"));
  }
  bool Learns(const std::string& service) const {
    return ConfigOf(service)["learning"].as<bool>();
  }
  bool AsksForConfirmation() const {
    return ConfigOf("planner")["exploration"]["confirmation"].as<bool>();
  }

  const TemporaryFolder folder_{"run-folder-test"};
  const RunFolder run_ = RunFolder::Create(folder_.path() / "run", "test",
                                           ShippedDeployment(), "assembly", 1);
};

TEST_F(RunFolderTest, LearningIsOnOrOffForRecognizerAndPlanner) {
  for (const bool is_learning : {true, false}) {
    run_.SetLearning(is_learning);
    EXPECT_EQ(Learns("recognizer"), is_learning);
    EXPECT_EQ(Learns("planner"), is_learning);
  }
  EXPECT_TRUE(AsksForConfirmation());
}

TEST_F(RunFolderTest, ConfirmationCanBeLeftOut) {
  run_.DoWithoutConfirmation();
  EXPECT_FALSE(AsksForConfirmation());
  EXPECT_FALSE(Learns("planner"));
}

TEST_F(RunFolderTest, FromNothingOnlyTheArmsOwnSkillsAreKnown) {
  run_.LearnFromNothing();
  EXPECT_TRUE(Learns("recognizer"));
  EXPECT_TRUE(Learns("planner"));
  EXPECT_FALSE(AsksForConfirmation());
  const YAML::Node domain =
      YAML::LoadFile(run_.deployment.OfTask("domain.yaml").file());
  for (const auto& action : domain["actions"]) {
    EXPECT_TRUE(action.second["rules"]) << action.first;
  }
  EXPECT_GT(domain["actions"].size(), 0u);
}

}  // namespace
}  // namespace cell
