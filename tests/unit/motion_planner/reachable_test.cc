// What arms report as reachable, what a search from the grasp to the site
// finds, and where scripts lay parts agree.
#include <gmock/gmock.h>

#include <cstdlib>
#include <numbers>
#include <random>

#include "services/motion_planner/motion_search.h"
#include "services/robot_arm/skill_settings.h"
#include "services/vtb/script.h"
#include "services/vtb/within_reach.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
using namespace vtb;
namespace {

using Eigen::Isometry3d;
using testing::IsEmpty;
using testing::SizeIs;
using Poses = std::map<std::string, Isometry3d>;

// One part of each type, and where it goes.
const std::map<std::string, std::string> kSites = {
    {"round_peg_1", "base.round_1"},  {"square_peg_1", "base.square_1"},
    {"shaft", "base.shaft"},          {"separator", "base.separator"},
    {"pendulum", "base.pendulum"},    {"head", "pendulum.head"},
    {"face_plate", "base.face_plate"}};

// Of each part; 1000 take minutes.
int NumPoses() {
  const char* text = std::getenv("CELL_REACH_POSES");
  return text == nullptr ? 8 : std::atoi(text);
}

class ReachableParts : public testing::TestWithParam<std::string> {
 protected:
  // Upright on the table.
  Isometry3d At(double x, double y, double yaw) const {
    Isometry3d X_WO(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    X_WO.translation() << x, y, 0;
    X_WO.translation().z() = -shape_.LowestZ(X_WO);
    return X_WO;
  }
  double Between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double Yaw() { return Between(-std::numbers::pi, std::numbers::pi); }
  // The cell with nothing else in the way; the head's host stands.
  Poses With(const Isometry3d& X_WO) const {
    Poses poses = {{"base", task_.layout.pedestal.X_WP}, {part_, X_WO}};
    if (part_ == "head") {
      poses["pendulum"] =
          poses["base"] * task_.parts.FindSite("base.pendulum")->X_HS;
    }
    return poses;
  }
  MotionRequest Request(MotionRequest::Kind kind, const ArmLayout& arm,
                        const Poses& poses, const ArmPosture& posture) const {
    MotionRequest request;
    request.kind = kind;
    request.arm = arm.name;
    request.arms[arm.name].posture = posture;
    request.parts = poses;
    request.part = part_;
    request.wanted = {part_};
    return request;
  }
  bool IsReported(const ArmLayout& arm, const Poses& poses) const {
    return !search_
                .Find(Request(MotionRequest::Kind::kReach, arm, poses,
                              HomePosture(arm)))
                .reachable.empty();
  }
  // Why the arm cannot do with the part what it is for, from home to the end of
  // the way; empty if it can.
  std::string WhyNot(const ArmLayout& arm, const Poses& poses) const {
    const Site& site = *task_.parts.FindSite(kSites.at(part_));
    std::optional<PlaceTarget> target;
    if (arm.X_FS) target = TargetAt(site, poses.at(site.host));
    if (target && task_.parts.FindThread(site.type)) {
      target->turn = -settings_.screwing.tight.max_angle;
    }
    MotionRequest take =
        Request(MotionRequest::Kind::kGrasp, arm, poses, HomePosture(arm));
    take.target = target;
    const MotionPlan pick = search_.Find(take);
    if (!pick) return pick.reason;
    const GraspChoice& grasp = pick.grasp;
    MotionRequest put = Request(
        target ? MotionRequest::Kind::kPlace : MotionRequest::Kind::kSetDown,
        arm, poses, {grasp.q_approach, grasp.grip, grasp.width});
    put.arms[arm.name].held = ArmScene::Held{part_, grasp.X_OG.inverse()};
    put.target = target;
    put.area = arm.exchange;
    put.is_for_other_arm = true;
    return search_.Find(put).reason;
  }
  bool IsAnyReported(const Poses& poses) const {
    return std::ranges::any_of(task_.layout.arms, [&](const ArmLayout& arm) {
      return IsReported(arm, poses);
    });
  }

  const std::string part_ = GetParam();
  ShippedTask task_;
  SkillSettings settings_ = SkillSettings::FromConfig(
      ShippedDeployment().OfTask("skills.yaml"), task_.parts);
  motion_planner::MotionSearch search_{
      {task_.layout, task_.parts, settings_.motion, settings_.fingers}};
  PartShape shape_{*task_.parts.Find(part_)};
  std::mt19937_64 random_{42};
};

TEST_P(ReachableParts, AreReportedJustWhenThereIsAWayToTheEnd) {
  for (int i = 0; i < NumPoses(); ++i) {
    const Poses poses =
        With(At(Between(-0.43, 0.53), Between(-0.67, -0.13), Yaw()));
    for (const ArmLayout& arm : task_.layout.arms) {
      const bool is_reported = IsReported(arm, poses);
      const std::string why = WhyNot(arm, poses);
      EXPECT_EQ(is_reported, why.empty())
          << i << ", " << arm.name << " arm, at "
          << poses.at(part_).translation().transpose() << ": " << why;
    }
  }
}

TEST_P(ReachableParts, AreReportedByAnArmWhereScriptsLayThem) {
  const auto demonstrations = Demonstrations::FromConfig(
      ShippedDeployment().OfTask("demonstrators.yaml"), task_.parts);
  const WithinReach reach(task_.parts, task_.layout);
  const auto& places =
      demonstrations.scripts.at("execution_to_the_left").disturbance->places;
  ASSERT_THAT(places, testing::Not(IsEmpty()));
  for (const Eigen::Vector2d& place : places) {
    int num_laid = 0;
    for (int i = 0; i < NumPoses(); ++i) {
      const Isometry3d X_WO = At(place.x(), place.y(), Yaw());
      if (!reach.CanTake(part_, {{part_, X_WO}})) continue;
      ++num_laid;
      EXPECT_TRUE(IsAnyReported(With(X_WO))) << place.transpose();
    }
    EXPECT_GT(num_laid, 0) << place.transpose();
  }
}

TEST_P(ReachableParts, AreReportedByAnArmWhereTheyAreScattered) {
  const WithinReach reach(task_.parts, task_.layout);
  const PlacementSampler sampler(task_.parts, task_.layout, 0.040);
  for (int i = 0; i < NumPoses(); ++i) {
    const auto placed = sampler.Scatter(
        random_, [&](const auto& scene) { return reach.CanTakeAll(scene); });
    ASSERT_THAT(placed, SizeIs(9));
    const auto at =
        std::ranges::find(placed, part_, &PlacementSampler::Placed::part);
    EXPECT_TRUE(IsAnyReported(With(at->X_WO)))
        << at->X_WO.translation().transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachType, ReachableParts,
                         testing::Values("round_peg_1", "square_peg_1", "shaft",
                                         "separator", "pendulum", "head",
                                         "face_plate"),
                         [](const auto& part) { return part.param; });

}  // namespace
}  // namespace cell
