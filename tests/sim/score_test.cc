// The score of the shipped task, held to what it has been since the first
// measures: the same numbers by another way, on the truth of persons' runs and
// near it.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "common/geometry/pose.h"
#include "services/cell/scoring/assembly_score.h"
#include "services/vtb/demonstrator.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
using namespace vtb;
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kTick = 0.008;
constexpr double kMm = 1e-3, kDeg = std::numbers::pi / 180;
constexpr int kTicksApart = 25;   // of two looks
constexpr double kStill = 0.002;  // [m/s]
constexpr int kNumPerturbed = 3;  // of each look
constexpr double kLongest = 400;  // [s] of an episode

struct Rule {
  const char* part_type;
  const char* site_type;
  SeatTolerance seated;
};
constexpr SeatTolerance kCoarse{0.8 * kMm, 3 * kMm, 1 * kDeg, 10 * kDeg};
const Rule kRules[] = {
    {"round_peg", "round_hole", kCoarse},
    {"square_peg", "square_hole", kCoarse},
    {"shaft", "shaft_hole", kCoarse},
    {"separator", "separator_seat", {0.8 * kMm, 3 * kMm, 1 * kDeg, 5 * kDeg}},
    {"pendulum", "pendulum_seat", {0.8 * kMm, 4.5 * kMm, 1 * kDeg, 10 * kDeg}},
    {"head", "head_seat", {0.2 * kMm, 0.6 * kMm, 0.5 * kDeg, 180 * kDeg}},
    {"face_plate",
     "face_plate_seat",
     {0.8 * kMm, 2.2 * kMm, 1 * kDeg, 5 * kDeg}}};

using Poses = std::map<std::string, Isometry3d>;

Poses PosesOf(const World& world) {
  Poses poses;
  for (const Part& part : world.table().parts()) {
    poses[part.name] = world.PoseOf(part.name);
  }
  return poses;
}

truth_poses_t Look(const Poses& poses, int64_t utime) {
  truth_poses_t message{};
  message.header.utime = utime;
  for (const auto& [name, X_WO] : poses) {
    message.bodies.push_back({name, PoseToMessage(X_WO)});
  }
  message.num_bodies = static_cast<int32_t>(message.bodies.size());
  return message;
}

bool SitsAndRests(const Part& part, const Site& site, const Rule& rule,
                  const Poses& before, const Poses& after, double seconds) {
  const Isometry3d X_WS = after.at(site.host) * site.X_HS;
  const Isometry3d& X_WO = after.at(part.name);
  const double moved =
      (X_WO.translation() - before.at(part.name).translation()).norm();
  return part.type == rule.part_type && site.type == rule.site_type &&
         IsSeated(X_WS.inverse() * X_WO, part.symmetry_order, rule.seated) &&
         moved < kStill * seconds;
}

/// Sites, sorted, in which a part of the rule's type sits and rests.
std::vector<std::string> SeatedByTheRules(const Poses& before,
                                          const Poses& after, double seconds,
                                          const PartTable& table) {
  std::set<std::string> seated;
  for (const Rule& rule : kRules) {
    for (const Part& host : table.parts()) {
      for (const Site& site : host.sites) {
        for (const Part& part : table.parts()) {
          if (SitsAndRests(part, site, rule, before, after, seconds)) {
            seated.insert(site.name);
          }
        }
      }
    }
  }
  return {seated.begin(), seated.end()};
}

/// Some parts a little off, some within and some beyond every tolerance.
void Perturb(std::mt19937_64& random, Poses& poses) {
  std::uniform_real_distribution<double> unit(-1, 1);
  for (auto& [name, X_WO] : poses) {
    if (unit(random) > 0) continue;
    const double scale = std::abs(unit(random));
    const double x = 6 * kMm * scale * unit(random);
    const double z = 1.6 * kMm * scale * unit(random);
    const double tilt = 2 * kDeg * scale * unit(random);
    const double yaw = 20 * kDeg * scale * unit(random);
    X_WO = X_WO * Eigen::Translation3d(x, 0, z) *
           AngleAxisd(tilt, Vector3d::UnitX()) *
           AngleAxisd(yaw, Vector3d::UnitZ());
  }
}

struct Run {
  const char* script;
  uint64_t seed;
};
class Score : public testing::TestWithParam<Run> {};

TEST_P(Score, IsWhatTheRulesOfPlacementsSay) {
  const ShippedTask task;
  const auto success = SuccessCriterion::Load(ShippedDeployment());
  World world(task.parts, task.layout, {.dt = 0.002});
  const auto demonstrations =
      std::make_shared<Demonstrations>(Demonstrations::FromConfig(
          ShippedDeployment().OfTask("demonstrators.yaml"), task.parts));
  Demonstrator person(demonstrations, GetParam().script, GetParam().seed,
                      world);
  std::mt19937_64 random(GetParam().seed);
  constexpr double kApart = kTick * kTicksApart;  // [s]
  const auto compare = [&](const Poses& before, const Poses& after) {
    AssemblyScore score =
        ScoreAssembly(Look(before, 0),
                      Look(after, static_cast<int64_t>(1e6 * kApart)), success);
    EXPECT_EQ(score.seated,
              SeatedByTheRules(before, after, kApart, task.parts));
    EXPECT_EQ(score.seated.size() + score.missing.size(), 9u);
    EXPECT_EQ(score.placed.size(), score.seated.size());
    return score;
  };
  Poses before = PosesOf(world);
  std::set<std::vector<std::string>> seen, seen_perturbed;
  bool is_complete = false;
  while (world.time() < kLongest && !person.is_done()) {
    for (int tick = 0; tick < kTicksApart; ++tick) {
      person.Update(kTick, world);
      world.Run(4);
    }
    const Poses after = PosesOf(world);
    const AssemblyScore score = compare(before, after);
    is_complete = score.is_complete();
    seen.insert(score.seated);
    for (int i = 0; i < kNumPerturbed; ++i) {
      Poses off_before = before, off_after = after;
      std::mt19937_64 same = random;
      Perturb(same, off_before);
      Perturb(random, off_after);
      seen_perturbed.insert(compare(off_before, off_after).seated);
    }
    before = after;
  }
  EXPECT_TRUE(is_complete);
  EXPECT_GE(seen.size(), 9u);
  EXPECT_GT(seen_perturbed.size(), 50u);
}

INSTANTIATE_TEST_SUITE_P(Runs, Score,
                         testing::Values(Run{"assembly", 1001},
                                         Run{"take_backs", 1003},
                                         Run{"mistake_order", 1006}),
                         [](const auto& run) {
                           return std::string(run.param.script);
                         });

}  // namespace
}  // namespace cell
