#include "services/vtb/demonstrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "services/vtb/action_labeler.h"

namespace cell {

using namespace vtb;
namespace {

using Eigen::Isometry3d;

constexpr double kTick = 0.008;
constexpr double kLongest = 400;  // [s] of an episode

/// A person in a cell whose physics take 2 ms steps (bulk runs).
class Stage {
 public:
  Stage(const std::string& script, uint64_t seed)
      : world_(Load<PartTable>("parts.yaml"), Load<CellLayout>("cell.yaml"),
               {.dt = 0.002}),
        demonstrations_(
            std::make_shared<Demonstrations>(Demonstrations::FromConfig(
                Config::Load(Path("demonstrators.yaml")), world_.table()))),
        demonstrator_(demonstrations_, script, seed, world_) {}

  void Step() {
    demonstrator_.Update(kTick, world_);
    world_.Run(4);
  }
  /// Until all is done, and a second more.
  void Finish() {
    while (!demonstrator_.is_done() && world_.time() < kLongest) Step();
    for (int tick = 0; tick < 125; ++tick) Step();
  }
  /// Goes on from a moment of another stage.
  void ContinueFrom(const Stage& other) {
    world_.Restore(other.world_.Save());
    demonstrator_ = other.demonstrator_;
  }

  World& world() { return world_; }
  std::shared_ptr<const Demonstrations> demonstrations() const {
    return demonstrations_;
  }
  const Demonstrator& demonstrator() const { return demonstrator_; }

 private:
  static std::string Path(const std::string& file) {
    return CELL_SOURCE_DIR "/deploy/tasks/cranfield/" + file;
  }
  template <class T>
  static T Load(const std::string& file) {
    return T::FromConfig(Config::Load(Path(file)));
  }

  World world_;
  std::shared_ptr<const Demonstrations> demonstrations_;
  Demonstrator demonstrator_;
};

struct Tolerance {
  double height, offset, tilt;  // [mm, mm, deg]
};

Tolerance ToleranceOf(const std::string& type) {
  if (type == "pendulum") return {0.8, 4.5, 1};
  if (type == "head") return {0.2, 0.6, 0.5};
  if (type == "face_plate") return {0.8, 2.2, 1};
  return {0.8, 3, 1};
}

/// The site at which the part is seated; empty if at none.
std::string SeatOf(const Part& part, const World& world) {
  const Tolerance tolerance = ToleranceOf(part.type);
  for (const Part& host : world.table().parts()) {
    for (const Site& site : host.sites) {
      if (std::ranges::find(part.fits, site.type) == part.fits.end()) continue;
      const Isometry3d X_SO = (world.PoseOf(host.name) * site.X_HS).inverse() *
                              world.PoseOf(part.name);
      const double tilt = std::acos(std::min(1.0, X_SO.linear()(2, 2)));
      if (std::abs(X_SO.translation().z()) < 1e-3 * tolerance.height &&
          X_SO.translation().head<2>().norm() < 1e-3 * tolerance.offset &&
          tilt < tolerance.tilt * 0.01745) {
        return site.name;
      }
    }
  }
  return "";
}

int NumSeated(const World& world) {
  return static_cast<int>(std::ranges::count_if(
      world.table().parts(),
      [&](const Part& part) { return !SeatOf(part, world).empty(); }));
}

TEST(Demonstrator, InsertsTwoPegs) {
  Stage stage("two_pegs", 1000);
  stage.Finish();
  EXPECT_TRUE(stage.demonstrator().failures().empty());
  EXPECT_EQ(NumSeated(stage.world()), 2);
}

TEST(Demonstrator, RefusesAScriptThatIsNotThere) {
  EXPECT_THROW(Stage("dance", 1), std::invalid_argument);
}

struct Run {
  const char* script;
  uint64_t seed;
};
class WholeAssembly : public testing::TestWithParam<Run> {};

TEST_P(WholeAssembly, SeatsEveryPart) {
  Stage stage(GetParam().script, GetParam().seed);
  stage.Finish();
  EXPECT_TRUE(stage.demonstrator().is_done());
  EXPECT_TRUE(stage.demonstrator().failures().empty());
  for (const Part& part : stage.world().table().parts()) {
    if (part.is_fixed) continue;
    EXPECT_NE(SeatOf(part, stage.world()), "") << part.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scripts, WholeAssembly,
    testing::Values(Run{"assembly", 1001}, Run{"assembly_two_hands", 1002},
                    Run{"take_backs", 1003}, Run{"unknown_moves", 1004},
                    Run{"take_backs_and_unknown_moves", 1005},
                    Run{"mistake_order", 1006}),
    [](const auto& run) { return std::string(run.param.script); });

TEST(Demonstrator, LaysAPartOutsideTheWorkspace) {
  Stage stage("mistake_outside", 1000);
  stage.Finish();
  const World& world = stage.world();
  int num_outside = 0;
  for (const Part& part : world.table().parts()) {
    const Isometry3d X_WO = world.PoseOf(part.name);
    if (world.layout().workspace.contains(X_WO.translation())) continue;
    ++num_outside;
    EXPECT_LT(std::abs(X_WO.linear()(2, 2)), 0.1) << part.name << " lies";
  }
  EXPECT_EQ(num_outside, 1);
}

// The plate is put on a few pegs, on which it may jam: nothing but its seat
// says which.
TEST(Demonstrator, APartThatWasPutOnItsSiteIsSeatedThereOrLabeledNotSeated) {
  for (const uint64_t seed : {9003, 9008}) {
    Stage stage("early_face_plate", seed);
    ActionLabeler labeler(stage.demonstrations());
    std::vector<LabeledAction> of_plate;
    for (int64_t tick = 0; of_plate.empty(); ++tick) {
      ASSERT_LT(stage.world().time(), kLongest);
      stage.Step();
      for (const auto& action : labeler.Update(tick * kTickUs, stage.world())) {
        if (action.part == "face_plate") of_plate.push_back(action);
      }
    }
    const World& world = stage.world();
    const bool is_seated =
        !SeatOf(*world.table().Find("face_plate"), world).empty();
    EXPECT_EQ(of_plate[0].kind == LabeledAction::Kind::kPlaced, is_seated);
    EXPECT_EQ(of_plate[0].mistake, is_seated
                                       ? LabeledAction::Mistake::kOutOfOrder
                                       : LabeledAction::Mistake::kNotSeated);
  }
}

TEST(Demonstrator, VariesWithTheSeed) {
  Stage a("assembly", 1000), b("assembly", 1001);
  EXPECT_NE(a.world().PoseOf("shaft").matrix(),
            b.world().PoseOf("shaft").matrix());
}

TEST(Demonstrator, ASnapshotContinuesBitForBit) {
  Stage stage("assembly_two_hands", 1000), copy("assembly_two_hands", 1);
  for (int tick = 0; tick < 900; ++tick) stage.Step();
  copy.ContinueFrom(stage);
  for (int tick = 0; tick < 900; ++tick) {
    stage.Step();
    copy.Step();
  }
  for (const Part& part : stage.world().table().parts()) {
    EXPECT_EQ(stage.world().PoseOf(part.name).matrix(),
              copy.world().PoseOf(part.name).matrix())
        << part.name;
  }
}

TEST(Demonstrator, PutsPartsWhereTheScriptSaysThatTheyStart) {
  const std::string folder = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    World world(PartTable::FromConfig(Config::Load(folder + "parts.yaml")),
                CellLayout::FromConfig(Config::Load(folder + "cell.yaml")),
                {.dt = 0.002});
    auto demonstrations =
        std::make_shared<Demonstrations>(Demonstrations::FromConfig(
            Config::Load(folder + "demonstrators.yaml"), world.table()));
    demonstrations->scripts.at("execution").start = {
        {"round_peg_2", {}}, {"shaft", {}}, {"separator", {"base.separator"}}};
    const Demonstrator demonstrator(demonstrations, "execution", seed, world);
    for (int tick = 0; tick < 250; ++tick) world.Run(4);
    const auto tilt = [&](const char* part) {  // [rad]
      return std::acos(world.PoseOf(part).linear()(2, 2));
    };
    EXPECT_GT(tilt("round_peg_2"), 1.2) << seed;
    EXPECT_GT(tilt("shaft"), 1.2) << seed;
    EXPECT_LT(tilt("round_peg_1"), 0.01) << seed;
    EXPECT_EQ(SeatOf(*world.table().Find("separator"), world), "base.separator")
        << seed;
    for (const char* part : {"round_peg_2", "shaft", "separator"}) {
      EXPECT_LT(world.SpeedOf(part), 0.002) << part << seed;
    }
  }
}

}  // namespace
}  // namespace cell
