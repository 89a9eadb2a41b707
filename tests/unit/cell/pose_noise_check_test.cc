#include "services/cell/running/pose_noise_check.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/test_folder.h"

namespace cell {

using namespace cli;
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PoseNoiseCheck : public testing::Test {
 protected:
  PoseNoiseCheck() { deployment_.config_dir = NewTestFolder(); }
  ~PoseNoiseCheck() override {
    std::filesystem::remove_all(deployment_.config_dir);
  }

  void Write(const std::string& service, const std::string& text) const {
    std::ofstream(deployment_.config_dir / (service + ".yaml")) << text;
  }
  std::string Complaint() const {
    try {
      CheckPoseNoise(deployment_);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  Deployment deployment_;
};

TEST_F(PoseNoiseCheck, AcceptsOneNoiseAndNamesTheServiceThatIsToldAnother) {
  Write("sec_builder", "pose_noise_mm: 2\n");
  Write("recognizer", "pose_noise_mm: 2\npose_noise_deg: 1\n");
  Write("predicate_estimator", "pose_noise_mm: 2\npose_noise_deg: 1\n");
  EXPECT_EQ(Complaint(), "");
  Write("predicate_estimator", "pose_noise_mm: 2\npose_noise_deg: 0\n");
  EXPECT_THAT(Complaint(),
              AllOf(HasSubstr("predicate_estimator.yaml:pose_noise_deg"),
                    HasSubstr("recognizer.yaml says 1")));
  Write("recognizer", "pose_noise_mm: 1\npose_noise_deg: 0\n");
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("recognizer.yaml:pose_noise_mm"),
                                 HasSubstr("sec_builder.yaml says 2")));
}

}  // namespace
}  // namespace cell
