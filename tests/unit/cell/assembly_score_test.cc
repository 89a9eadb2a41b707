#include "services/cell/scoring/assembly_score.h"

#include <gmock/gmock.h>

#include <map>

#include "common/geometry/pose.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::IsEmpty;

class AssemblyScoreTest : public testing::Test {
 protected:
  AssemblyScoreTest() {
    stage_.SeatAll();
    for (const Part& part : task_.parts.parts()) {
      poses_[part.name] = stage_.PoseOf(part.name);
    }
  }

  truth_poses_t Look(int64_t utime) const {
    truth_poses_t message{};
    message.header.utime = utime;
    for (const auto& [name, X_WO] : poses_) {
      message.bodies.push_back({name, PoseToMessage(X_WO)});
    }
    message.num_bodies = static_cast<int32_t>(message.bodies.size());
    return message;
  }
  AssemblyScore Score() const {
    return ScoreAssembly(Look(0), Look(200'000), success_);
  }
  void Shift(const std::string& part, const Vector3d& by) {
    poses_[part] = poses_[part] * Translation3d(by);
  }
  void Turn(const std::string& part, double degrees, const Vector3d& axis) {
    poses_[part] = poses_[part] * Eigen::AngleAxisd(degrees * M_PI / 180, axis);
  }

  ShippedTask task_;
  Stage stage_{task_};
  SuccessCriterion success_ = SuccessCriterion::Load(ShippedDeployment());
  std::map<std::string, Isometry3d> poses_;
};

TEST_F(AssemblyScoreTest, TheFinishedAssemblyIsComplete) {
  const AssemblyScore score = Score();
  EXPECT_THAT(score.missing, IsEmpty());
  EXPECT_EQ(score.seated.size(), 9u);
  EXPECT_TRUE(score.is_complete());
}

TEST_F(AssemblyScoreTest, AlmostIsNotSeated) {
  struct Case {
    const char* part;
    const char* site;
    Vector3d shift;
    double tilt_deg;
    double yaw_deg;
  };
  for (const Case& c : {
           Case{"round_peg_1", "base.round_1", {0, 0, 0.001}, 0, 0},
           Case{"round_peg_1", "base.round_1", {0, 0, 0}, 1.2, 0},
           Case{"square_peg_2", "base.square_2", {0.0032, 0, 0}, 0, 0},
           Case{"square_peg_2", "base.square_2", {0, 0, 0}, 0, 45},
           Case{"separator", "base.separator", {0, 0, 0}, 0, 180},
           Case{"head", "pendulum.head", {0, 0, 0.0003}, 0, 0},
           Case{"head", "pendulum.head", {0, 0, 0}, 0.6, 0},
           Case{"face_plate", "base.face_plate", {0.0025, 0, 0}, 0, 0},
       }) {
    const auto before = poses_;
    Shift(c.part, c.shift);
    Turn(c.part, c.tilt_deg, Vector3d::UnitX());
    Turn(c.part, c.yaw_deg, Vector3d::UnitZ());
    EXPECT_THAT(Score().missing, ElementsAre(c.site)) << c.part;
    poses_ = before;
  }
}

TEST_F(AssemblyScoreTest, WhatLooksTheSameCountsTheSame) {
  Turn("round_peg_1", 73, Vector3d::UnitZ());
  Turn("square_peg_1", 90, Vector3d::UnitZ());
  std::swap(poses_["round_peg_1"], poses_["round_peg_2"]);
  EXPECT_TRUE(Score().is_complete());
}

TEST_F(AssemblyScoreTest, APartOfAnotherTypeInTheSiteDoesNotCount) {
  std::swap(poses_["round_peg_1"], poses_["square_peg_1"]);
  EXPECT_THAT(Score().missing, ElementsAre("base.round_1", "base.square_1"));
}

TEST_F(AssemblyScoreTest, WhatMovesIsNotSeated) {
  const truth_poses_t earlier = Look(0);
  Shift("shaft", {0.0006, 0, 0});
  EXPECT_THAT(ScoreAssembly(earlier, Look(200'000), success_).missing,
              ElementsAre("base.shaft"));
}

TEST_F(AssemblyScoreTest, WhatSitsOnAMissingPartIsMissingToo) {
  poses_.erase("pendulum");
  EXPECT_THAT(Score().missing, ElementsAre("base.pendulum", "pendulum.head"));
}

TEST_F(AssemblyScoreTest, TwoSnapshotsMustBeApart) {
  EXPECT_THROW(ScoreAssembly(Look(0), Look(50'000), success_),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell
