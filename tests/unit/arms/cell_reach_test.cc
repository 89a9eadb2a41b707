// Does the shipped cell work? Every insertion within reach of the arm that
// inserts, every part of some arm, a place for both, a view of it all.
#include <gmock/gmock.h>

#include <fstream>
#include <random>
#include <sstream>

#include "common/arms/cell_check.h"
#include "common/arms/path_planner.h"
#include "common/arms/reach.h"
#include "common/geometry/degree.h"
#include "common/kinematics/arm_models.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/renderer.h"
#include "services/vtb/placement_sampler.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace vtb;
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kTilt = 5 * kDegree;

struct Step {
  const char* part;
  const char* site;
};
// In an order that the task allows.
constexpr Step kAssembly[] = {
    {"round_peg_1", "base.round_1"},   {"round_peg_2", "base.round_2"},
    {"square_peg_1", "base.square_1"}, {"square_peg_2", "base.square_2"},
    {"shaft", "base.shaft"},           {"separator", "base.separator"},
    {"pendulum", "base.pendulum"},     {"head", "pendulum.head"},
    {"face_plate", "base.face_plate"}};

// A grasp and a placement with it.
struct Placing {
  Isometry3d X_OG;
  PlaceChoice place;
};

JointPath PlanUr5Path(const Joints& start, const std::vector<Joints>& goals,
                      const std::vector<Joints>& vias,
                      const WhyBlockedAt& why_blocked) {
  return cell::PlanPath(start, goals, vias, why_blocked,
                        PathPlannerParams(*FindArmModel("ur5")));
}

class CellReach : public testing::Test {
 protected:
  const ArmLayout& Arm(const std::string& name) const {
    return *task_.layout.FindArm(name);
  }

  // Every grasp, and each turned by pi.
  std::vector<Placing> WaysToPlace(const ArmScene& scene,
                                   const std::string& arm,
                                   const std::string& part,
                                   const PlaceTarget& target) const {
    const Reach reach(scene, arm);
    std::vector<Placing> ways;
    for (const Grasp& grasp : task_.parts.Find(part)->grasps) {
      for (const std::string& grip : grasp.grips) {
        if (Arm(arm).hand.FindGrip(grip) == nullptr) continue;
        for (const double turn : {0.0, std::numbers::pi}) {
          const Isometry3d X_OG =
              grasp.X_OG * AngleAxisd(turn, Vector3d::UnitZ());
          const auto places = reach.Placements(
              part, X_OG.inverse(), grip, grasp.width, target, Arm(arm).home);
          if (!places) continue;
          for (const PlaceChoice& place : *places) {
            ways.push_back({X_OG, place});
          }
        }
      }
    }
    return ways;
  }

  // The straight way in, were the part tilted by 5 deg any way.
  bool HasTiltMargin(const ArmLayout& arm, const Placing& way,
                     const PlaceTarget& target) const {
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0),
                                 Vector3d(0, 1, 0), Vector3d(0, -1, 0)}) {
      const Isometry3d X_WG =
          way.place.X_WO * AngleAxisd(kTilt, axis) * way.X_OG;
      const auto q = TrackPose(arm, X_WG, way.place.q_place);
      const Isometry3d X_WG_begin =
          Eigen::Translation3d(target.approach * target.way_out) * X_WG;
      if (!q || !TrackLine(arm, *q, X_WG_begin)) return false;
    }
    return true;
  }

  // Visits each step of the assembly with the parts of the steps before seated.
  template <class Visit>
  void Assemble(const Visit& visit) const {
    ArmScene scene(task_.parts, task_.layout);
    std::map<std::string, Isometry3d> X_W = {
        {"base", task_.layout.pedestal.X_WP}};
    for (const auto& [part, site_name] : kAssembly) {
      const Site& site = *task_.parts.FindSite(site_name);
      const PlaceTarget target = TargetAt(site, X_W.at(site.host));
      visit(scene, part, site, target);
      X_W[part] = target.X_WO;
      scene.PutPart(part, target.X_WO);
    }
  }

  ShippedTask task_;
};

TEST_F(CellReach, HomesAreFreeOfAllThatStands) {
  EXPECT_EQ(WhyCellImpossible(task_.parts, task_.layout), std::nullopt);
}

TEST_F(CellReach, TheArmThatInsertsReachesEverySiteWithMarginToTilt) {
  const ArmLayout& arm = Arm("right");
  ASSERT_TRUE(arm.X_FS.has_value());
  Assemble([&](const ArmScene& scene, const std::string& part, const Site&,
               const PlaceTarget& target) {
    ASSERT_DOUBLE_EQ(target.approach, 0.100);
    const auto ways = WaysToPlace(scene, arm.name, part, target);
    EXPECT_TRUE(std::ranges::any_of(
        ways,
        [&](const Placing& way) { return HasTiltMargin(arm, way, target); }))
        << part << ": " << ways.size() << " ways, none with a margin";
  });
}

TEST_F(CellReach, WhatIsScrewedInTurnsFarEnough) {
  int num_threaded = 0;
  Assemble([&](const ArmScene& scene, const std::string& part, const Site& site,
               PlaceTarget target) {
    const Thread* thread = task_.parts.FindThread(site.type);
    if (thread == nullptr) return;
    ++num_threaded;
    EXPECT_NEAR(target.way_out.z(), 0, 1e-9);  // from the side
    target.turn = -405 * kDegree;
    EXPECT_GE(-target.turn / (2 * std::numbers::pi) * thread->pitch,
              thread->engagement - 1e-9);
    EXPECT_FALSE(WaysToPlace(scene, "right", part, target).empty());
  });
  EXPECT_EQ(num_threaded, 1);
}

TEST_F(CellReach, EveryScatteredPartIsWithinReachOfAnArm) {
  std::mt19937_64 random(7);
  const PlacementSampler sampler(task_.parts, task_.layout, 0.040);
  std::map<std::string, int> num_taken;
  int num_parts = 0, num_either = 0;
  for (int i = 0; i < 40; ++i) {
    const auto placed = sampler.Scatter(random);
    ArmScene scene(task_.parts, task_.layout);
    for (const auto& [part, X_WO] : placed) scene.PutPart(part, X_WO);
    for (const auto& [part, X_WO] : placed) {
      ++num_parts;
      bool is_taken = false;
      for (const ArmLayout& arm : task_.layout.arms) {
        if (!Reach(scene, arm.name).Grasps(part, arm.home)) continue;
        ++num_taken[arm.name];
        is_taken = true;
      }
      num_either += is_taken ? 1 : 0;
    }
  }
  // Of 200 scatterings .943, .812 and 1 were measured: the left arm's workspace
  // ends at x = 0.30, within the parts area.
  EXPECT_GE(num_taken["right"], 0.92 * num_parts);
  EXPECT_GE(num_taken["left"], 0.78 * num_parts);
  EXPECT_GE(num_either, 0.995 * num_parts);
}

TEST_F(CellReach, WhatIsTakenFromTheTableFindsItsWayToTheSite) {
  std::mt19937_64 random(11);
  const PlacementSampler sampler(task_.parts, task_.layout, 0.040);
  const ArmLayout& arm = Arm("right");
  int num_parts = 0, num_transfers = 0;
  for (int i = 0; i < 10; ++i) {
    const auto placed = sampler.Scatter(random);
    Assemble([&](ArmScene scene, const std::string& part, const Site&,
                 const PlaceTarget& target) {
      for (const auto& [other, X_WO] : placed) {
        if (!scene.PoseOf(other)) scene.PutPart(other, X_WO);
      }
      ++num_parts;
      const auto transfers =
          Reach(scene, arm.name).Transfers(part, target, arm.home);
      if (!transfers) return;  // a case for the other arm
      ++num_transfers;
      const auto& [grasp, place, is_same_configuration] = transfers->front();
      EXPECT_TRUE(is_same_configuration) << part;
      const auto way = [&](const Joints& from, const Joints& to,
                           double opening) {
        const JointPath path = PlanUr5Path(
            from, {to}, {arm.home},
            AskScene(scene, arm.name, {from, grasp.grip, opening}, {}));
        EXPECT_TRUE(path) << part << ": " << path.reason();
      };
      way(arm.home, grasp.q_approach, grasp.opening);
      scene.Hold(arm.name, part, grasp.X_OG.inverse());
      way(grasp.q_approach, place.q_approach, grasp.width);
      scene.PutPart(part, place.X_WO);
      way(place.q_approach, arm.home, grasp.opening);
    });
  }
  // Of 200 scatterings .954 were measured, and every way was found.
  EXPECT_GE(num_transfers, 0.92 * num_parts);
}

TEST_F(CellReach, EveryGripThatAPartNamesIsAHands) {
  for (const Part& part : task_.parts.parts()) {
    for (const Grasp& grasp : part.grasps) {
      for (const std::string& grip : grasp.grips) {
        EXPECT_TRUE(std::ranges::any_of(task_.layout.AllHands(),
                                        [&](const CellLayout::NamedHand& hand) {
                                          return hand.type->FindGrip(grip) !=
                                                 nullptr;
                                        }))
            << part.name << ": " << grip;
      }
    }
  }
}

TEST_F(CellReach, WhereTheyExchangeEitherArmTakesWhatTheOtherSetDown) {
  for (const Part& part : task_.parts.parts()) {
    if (part.is_fixed) continue;
    const PartShape shape(part);
    std::map<std::string, int> num_ways;  // yaws that serve, by arm
    int num_both = 0;
    for (int i = 0; i < 12; ++i) {
      PlaceTarget target;
      target.X_WO = AngleAxisd(i * 30 * kDegree, Vector3d::UnitZ());
      target.X_WO.translation() << Arm("right").exchange.center(), 0;
      target.X_WO.translation().z() -= shape.LowestZ(target.X_WO);
      int num_arms = 0;
      for (const ArmLayout& arm : task_.layout.arms) {
        ArmScene scene(task_.parts, task_.layout);
        const bool may_set_down =
            !WaysToPlace(scene, arm.name, part.name, target).empty();
        scene.PutPart(part.name, target.X_WO);
        if (may_set_down &&
            Reach(scene, arm.name).Grasps(part.name, arm.home)) {
          ++num_arms;
        }
      }
      num_both += num_arms == 2 ? 1 : 0;
    }
    EXPECT_GE(num_both, 2) << part.name;
  }
}

class CellCameras : public CellReach {
 protected:
  // Where parts can be, a little above the table, and every site.
  std::vector<Vector3d> Points() const {
    std::vector<Vector3d> points;
    const auto& area = task_.layout.parts_area;
    for (double u = -0.5; u <= 0.5; u += 0.1) {
      for (double v = -0.5; v <= 0.5; v += 0.1) {
        points.emplace_back(area.centre.x() + u * area.size.x(),
                            area.centre.y() + v * area.size.y(), 0.001);
      }
    }
    std::map<std::string, Isometry3d> X_W = {
        {"base", task_.layout.pedestal.X_WP}};
    for (const auto& [part, site_name] : kAssembly) {
      const Site& site = *task_.parts.FindSite(site_name);
      X_W[part] = X_W.at(site.host) * site.X_HS;
      points.push_back(X_W[part].translation());
    }
    return points;
  }

  const CameraLayout& cameras() const { return *task_.layout.cameras; }
};

TEST_F(CellCameras, StandAtAThirdOfATurnFromEachOther) {
  ASSERT_TRUE(task_.layout.cameras.has_value());
  const auto& azimuths = cameras().azimuths;
  ASSERT_EQ(azimuths.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::abs(std::remainder(azimuths[i] - azimuths[(i + 1) % 3],
                                        360 * kDegree)),
                120 * kDegree, 1e-9);
  }
  for (const Isometry3d& X_WC : cameras().Poses()) {
    EXPECT_NEAR((X_WC.inverse() * cameras().p_W_look_at -
                 Vector3d(0, 0, cameras().distance))
                    .norm(),
                0, 1e-9);
    EXPECT_NEAR(X_WC.linear().determinant(), 1, 1e-9);
    EXPECT_LT(X_WC.linear()(2, 1), 0);  // y points down
  }
}

TEST_F(CellCameras, AtLeastTwoHaveEveryPointInView) {
  for (const Vector3d& p_W : Points()) {
    int num = 0;
    for (const Isometry3d& X_WC : cameras().Poses()) {
      num += cameras().IsInView(X_WC, p_W) ? 1 : 0;
    }
    EXPECT_GE(num, 2) << p_W.transpose();
  }
}

TEST_F(CellCameras, AtLeastTwoSeeTheFreePartsAreaPastTheArmsAtHome) {
  const RenderScene scene(BodiesOf(task_.parts, task_.layout));
  std::map<std::string, Isometry3d> X_WO = {
      {"base", task_.layout.pedestal.X_WP}};
  for (const ArmLayout& arm : task_.layout.arms) {
    X_WO.merge(NamedBodyPosesOf(arm, HomePosture(arm)));
  }
  RenderParams params;
  params.has_shadows = false;
  const auto& area = task_.layout.parts_area;
  std::map<std::pair<int, int>, int> num_seen;
  for (const Isometry3d& X_WC : cameras().Poses()) {
    const Camera camera = CameraWithView(X_WC, 640, 480, cameras().view_angles);
    const RenderImage image = Render(scene, X_WO, camera, params);
    for (int i = -10; i <= 10; ++i) {
      for (int j = -10; j <= 10; ++j) {
        const Vector3d p_C =
            X_WC.inverse() * Vector3d(area.centre.x() + i * area.size.x() / 20,
                                      area.centre.y() + j * area.size.y() / 20,
                                      0);
        const auto column =
            std::lround(camera.fx * p_C.x() / p_C.z() + camera.cx);
        const auto row = std::lround(camera.fy * p_C.y() / p_C.z() + camera.cy);
        num_seen[{i, j}] += 0;
        if (column < 0 || column >= camera.width || row < 0 ||
            row >= camera.height) {
          continue;
        }
        const double depth = image.depth[image.Index(static_cast<int>(column),
                                                     static_cast<int>(row))];
        num_seen[{i, j}] += std::abs(depth - p_C.z()) < 0.010 ? 1 : 0;
      }
    }
  }
  const auto is_seen = [](const auto& entry) {
    return entry.second >= 2;
  };
  EXPECT_EQ(std::ranges::count_if(num_seen, is_seen),
            static_cast<std::ptrdiff_t>(num_seen.size()));
}

TEST(CellHome, IsWhereTheCellSaysForAnyModelThatReachesIt) {
  std::ifstream file(ShippedDeployment().task_dir / "cell.yaml");
  std::stringstream stream;
  stream << file.rdbuf();
  for (const std::string& model : ArmModelNames()) {
    if (model == "ur3" || model == "ur3e") continue;
    std::string text = stream.str();
    for (size_t at = 0; (at = text.find("model: ur5\n", at)) != text.npos;
         ++at) {
      text.replace(at, 10, "model: " + model);
    }
    const CellLayout layout =
        CellLayout::FromConfig(Config::Parse(text, "cell.yaml"));
    const ArmLayout& right = *layout.FindArm("right");
    EXPECT_EQ(right.model->name(), model);
    const Isometry3d X_WG = GripperPose(right, right.home);
    EXPECT_LT((X_WG.translation() - Vector3d(0.4175, -0.3591, 0.4699)).norm(),
              0.003)
        << model;
    EXPECT_GT(X_WG.linear()(2, 2), 0.99999) << model;
    EXPECT_FALSE(right.model->IsNearSingularity(right.home)) << model;
    const Joints tenths = right.home / kDegree * 10;
    EXPECT_LT((tenths - tenths.array().round().matrix()).cwiseAbs().maxCoeff(),
              1e-9);
  }
}

// What a cell.yaml with a changed line is refused for.
std::string WhyRefused(const std::string& from, const std::string& to) {
  std::ifstream file(ShippedDeployment().task_dir / "cell.yaml");
  std::stringstream stream;
  stream << file.rdbuf();
  std::string text = stream.str();
  const size_t at = text.find(from);
  if (at == std::string::npos) return "cell.yaml has no " + from;
  text.replace(at, from.size(), to);
  try {
    const Config config = Config::Parse(text, "cell.yaml");
    const CellLayout layout = CellLayout::FromConfig(config);
    CheckCell(config, ShippedTask().parts, layout);
  } catch (const ConfigError& error) {
    const std::string what = error.what();
    return what.substr(0, what.rfind(" (line "));
  }
  return "";
}

TEST(CellCheck, AcceptsTheShippedCell) {
  EXPECT_EQ(WhyRefused("", ""), "");
}

TEST(CellCheck, RefusesHomesThatCollide) {
  EXPECT_THAT(WhyRefused("xyz: [-0.40, 0.00", "xyz: [0.40, 0.00"),
              testing::MatchesRegex(
                  "cell.yaml:arms.left.home: .*_left.* would hit .*_right.*"));
  EXPECT_THAT(
      WhyRefused("home: {xyz: [0.4175, -0.3591, 0.4699]",
                 "home: {xyz: [0.1175, -0.3591, 0.0050]"),
      testing::MatchesRegex("cell.yaml:arms.right.home: .* would hit .*"));
}

TEST(CellCheck, AcceptsAnyModelThatReachesItsHomeAndOnlyThose) {
  for (const std::string arm : {"right", "left"}) {
    for (const std::string& model : ArmModelNames()) {
      const bool is_short = model == "ur3" || model == "ur3e";
      EXPECT_EQ(
          WhyRefused(arm + ":\n    model: ur5", arm + ":\n    model: " + model),
          is_short
              ? "cell.yaml:arms." + arm + ".home: out of reach of a " + model
              : "");
    }
  }
}

TEST(CellCheck, RefusesWhatCannotBe) {
  EXPECT_EQ(WhyRefused("xyz: [0.50, -0.05, 0.10]", "xyz: [0.50, -0.05, -0.01]"),
            "cell.yaml:arms.right.base: lies below the table's top");
  EXPECT_EQ(
      WhyRefused("home: {xyz: [-0.2405, 0.2770", "home: {xyz: [-0.2405, 0.45"),
      "cell.yaml:arms.left.home: the gripper is outside the arm's "
      "workspace");
  EXPECT_EQ(WhyRefused("home: {xyz: [0.4175,", "home: {xyz: [-0.9,"),
            "cell.yaml:arms.right.home: out of reach of a ur5");
  EXPECT_EQ(WhyRefused("rpy_deg: [0, 0, -5.7]", "rpy_deg: [0, 10, -5.7]"),
            "cell.yaml:arms.right.base: leans");
  EXPECT_EQ(WhyRefused("mass: 2.40", "mass: 6"),
            "cell.yaml:arms.right.tool.mass: a ur5 carries 5 kg");
  EXPECT_EQ(WhyRefused("right:\n    model: ur5", "right:\n    model: ur7"),
            "cell.yaml:arms.right.model: there is no arm model 'ur7'; known: "
            "ur10, ur10e, ur16e, ur3, ur3e, ur5, ur5e");
  EXPECT_EQ(
      WhyRefused("exchange: {low: [-0.20, -0.58], high: [0.26",
                 "exchange: {low: [-0.20, -0.58], high: [1.26"),
      "cell.yaml:arms.right.exchange: reaches out of the arm's workspace");
  EXPECT_THAT(WhyRefused("elevation_deg: 50", "elevation_deg: 90"),
              StartsWith("cell.yaml:cameras.elevation_deg"));
  EXPECT_THAT(WhyRefused("view_deg: [57, 43]", "view_deg: [57, 0]"),
              StartsWith("cell.yaml:cameras.view_deg"));
}

}  // namespace
}  // namespace cell
