#include "common/predicates/predicate_sensor.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "common/geometry/degree.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

const std::string kRight = "hand_right";

class PredicateSensorTest : public testing::Test {
 protected:
  // "PegInHole(shaft, base.shaft)"
  Truth Of(const std::string& atom) { return In(Sensed(), atom); }

  State Sensed() {
    return sensor_->Sense(SceneOf(stage_.Frame(), task_.scene_objects));
  }

  Truth In(const State& state, const std::string& atom) {
    for (int i = 0; i < state.num_atoms(); ++i) {
      if (task_.domain.vocabulary().AtomName(i) == atom) return state.Get(i);
    }
    ADD_FAILURE() << atom << " is no atom";
    return Truth::kUnknown;
  }

  void ExpectReached(const std::string& goal) {
    const State state = Sensed();
    for (const Literal& literal : task_.domain.FindGoal(goal)->literals) {
      EXPECT_TRUE(MustHold(literal, {}, state, task_.domain.vocabulary()))
          << Show(literal, {}, task_.domain.vocabulary());
    }
  }

  ShippedTask task_;
  Stage stage_{task_};
  std::shared_ptr<const PredicateSensor> sensor_ = task_.MakeSensor();
};

TEST_F(PredicateSensorTest, AtFirstAllPartsAreClearAndAllHolesFree) {
  const State state = Sensed();
  const Vocabulary& v = task_.domain.vocabulary();
  for (int i = 0; i < state.num_atoms(); ++i) {
    const std::string name = v.AtomName(i);
    if (v.predicates()[v.Atom(i).predicate].report) {
      EXPECT_EQ(state.Get(i), Truth::kUnknown) << name;  // no geometry tells
      continue;
    }
    const bool expected = name.starts_with("Clear") || name.starts_with("Free");
    EXPECT_EQ(state.Get(i), expected ? Truth::kTrue : Truth::kFalse) << name;
  }
}

TEST_F(PredicateSensorTest, InTheWholeAssemblyTheGoalIsReached) {
  stage_.SeatAll();
  ExpectReached("assembled");
}

// Also if symmetric parts are turned by any step of their symmetry.
TEST_F(PredicateSensorTest, TurnedBySymmetryTheGoalIsReachedToo) {
  stage_.SeatAll();
  for (int i = 0; i < 4; ++i) {
    const Isometry3d quarter(
        AngleAxisd(i * std::numbers::pi / 2, Vector3d::UnitZ()));
    const Isometry3d any(AngleAxisd(i * 0.7, Vector3d::UnitZ()));
    stage_.Seat("square_peg_1", "base.square_1", quarter);
    stage_.Seat("shaft", "base.shaft", quarter);
    stage_.Seat("round_peg_2", "base.round_2", any);
    stage_.Seat("head", "pendulum.head", any);
    ExpectReached("assembled");
  }
}

TEST_F(PredicateSensorTest, SeatedEndsAtItsTolerances) {
  const auto off = [](double x, double z, double tilt) {
    return Translation3d(x, 0, z) * AngleAxisd(tilt, Vector3d::UnitX()) *
           Isometry3d::Identity();
  };
  const std::string atom = "PegInHole(square_peg_1, base.square_2)";
  for (const auto& [share, truth] :
       {std::pair{0.99, Truth::kTrue}, {1.01, Truth::kFalse}}) {
    for (const auto& X_SO :
         {off(share * 0.003, 0, 0), off(0, share * 0.0008, 0),
          off(0, -share * 0.0008, 0), off(0, 0, share * 1 * kDegree)}) {
      stage_.Seat("square_peg_1", "base.square_2", X_SO);
      EXPECT_EQ(Of(atom), truth) << share;
    }
  }
}

// Half a millimetre either way of the limit in z, which is 0.8 mm.
TEST_F(PredicateSensorTest, WhatUncertainPosesCannotDecideIsUnknown) {
  const auto uncertain = task_.MakeSensor({.position = 0.0005});
  const auto at_height = [&](double mm) {
    stage_.Seat("square_peg_1", "base.square_2",
                Isometry3d(Translation3d(0, 0, mm * 1e-3)));
    return In(uncertain->Sense(SceneOf(stage_.Frame(), task_.scene_objects)),
              "PegInHole(square_peg_1, base.square_2)");
  };
  EXPECT_EQ(at_height(0), Truth::kTrue);
  EXPECT_EQ(at_height(0.29), Truth::kTrue);
  EXPECT_EQ(at_height(0.31), Truth::kUnknown);
  EXPECT_EQ(at_height(1.29), Truth::kUnknown);
  EXPECT_EQ(at_height(1.31), Truth::kFalse);
  const auto very_uncertain = task_.MakeSensor({.position = 0.004});
  EXPECT_EQ(
      In(very_uncertain->Sense(SceneOf(stage_.Frame(), task_.scene_objects)),
         "PegInHole(square_peg_1, base.square_1)"),
      Truth::kFalse)
      << "another site is far away";
}

TEST_F(PredicateSensorTest, SeatedAsksForTouchAndFit) {
  stage_.Seat("shaft", "base.shaft");
  KeyFrame frame = stage_.Frame();
  const std::string atom = "PegInHole(shaft, base.shaft)";
  EXPECT_EQ(In(sensor_->Sense(SceneOf(frame, task_.scene_objects)), atom),
            Truth::kTrue);
  frame.relations[{"base", "shaft"}] = Relation::kNotTouching;
  EXPECT_EQ(In(sensor_->Sense(SceneOf(frame, task_.scene_objects)), atom),
            Truth::kFalse);
  stage_.Seat("round_peg_1", "base.shaft");
  EXPECT_EQ(Of("PegInHole(round_peg_1, base.shaft)"), Truth::kFalse);
}

TEST_F(PredicateSensorTest, HorizontalBeginsAt45Degrees) {
  for (const auto& [angle, truth] : {std::pair{44.9, Truth::kFalse},
                                     {45.1, Truth::kTrue},
                                     {134.9, Truth::kTrue},
                                     {135.1, Truth::kFalse}}) {
    stage_.Put("shaft", Translation3d(0, -0.4, 0.1) *
                            AngleAxisd(angle * kDegree, Vector3d::UnitY()) *
                            Isometry3d::Identity());
    EXPECT_EQ(Of("Horizontal(shaft)"), truth) << angle;
  }
}

TEST_F(PredicateSensorTest, PartsOutsideTheWorkspaceAreNotClear) {
  stage_.LieAt("round_peg_1", 0.55, -0.4);
  EXPECT_EQ(Of("Clear(round_peg_1)"), Truth::kTrue);
  stage_.LieAt("round_peg_1", 0.57, -0.4);
  EXPECT_EQ(Of("Clear(round_peg_1)"), Truth::kFalse);
  stage_.Hold(kRight, "round_peg_1");
  EXPECT_EQ(Of("Clear(round_peg_1)"), Truth::kTrue) << "in a hand";
}

TEST_F(PredicateSensorTest, WhatRestsOnAPartOrLiesOverItsGraspsCoversIt) {
  stage_.LieAt("head", 0.2, -0.4);
  stage_.StandAt("face_plate", 0.2, -0.4);
  stage_.Lift("face_plate", 0.07);  // over the head without touching it
  EXPECT_EQ(Of("Clear(head)"), Truth::kFalse);
  stage_.Hold(kRight, "face_plate");
  EXPECT_EQ(Of("Clear(head)"), Truth::kTrue) << "carried across";
}

// As the domain's rules have it.
TEST_F(PredicateSensorTest, OnlyTheFacePlateCoversWhatStandsOnTheBase) {
  stage_.SeatAll();
  const State with_plate = Sensed();
  stage_.StandAt("face_plate", 0.2, -0.4);
  const State without = Sensed();
  for (const char* part :
       {"shaft", "round_peg_1", "round_peg_2", "square_peg_1", "square_peg_2",
        "separator", "pendulum"}) {
    const std::string atom = std::string("Clear(") + part + ")";
    EXPECT_EQ(In(without, atom), Truth::kTrue) << part;
    EXPECT_EQ(In(with_plate, atom), Truth::kFalse) << part;
  }
  EXPECT_EQ(In(with_plate, "Clear(head)"), Truth::kTrue);
  EXPECT_EQ(In(with_plate, "Clear(face_plate)"), Truth::kTrue);
}

TEST_F(PredicateSensorTest, AHoleIsFreeUnlessSomethingIsInItOrAboveIt) {
  stage_.Seat("round_peg_1", "base.round_1");
  stage_.Seat("separator", "base.separator");
  stage_.Seat("pendulum", "base.pendulum");
  const State state = Sensed();
  EXPECT_EQ(In(state, "Free(base.round_1)"), Truth::kFalse);
  EXPECT_EQ(In(state, "Free(base.round_2)"), Truth::kTrue);
  EXPECT_EQ(In(state, "Free(base.square_1)"), Truth::kFalse);
  EXPECT_EQ(In(state, "Free(base.square_2)"), Truth::kFalse);
  EXPECT_EQ(In(state, "Free(base.shaft)"), Truth::kFalse);
}

TEST_F(PredicateSensorTest, APartCarriedAboveAHoleLeavesItFreeUntilItIsSeated) {
  const Isometry3d above(Translation3d(0, 0, 0.02));
  stage_.Seat("round_peg_1", "base.round_1", above);
  EXPECT_EQ(Of("Free(base.round_1)"), Truth::kFalse);
  stage_.Hold(kRight, "round_peg_1");
  EXPECT_EQ(Of("Free(base.round_1)"), Truth::kTrue);
  stage_.Seat("round_peg_1", "base.round_1");
  EXPECT_EQ(Of("Free(base.round_1)"), Truth::kFalse);
  EXPECT_EQ(Of("PegInHole(round_peg_1, base.round_1)"), Truth::kTrue);
}

// A hand that brushes what is seated changes no predicate.
TEST_F(PredicateSensorTest, TouchingTheAssemblyChangesNothing) {
  stage_.SeatAll();
  const State before = Sensed();
  for (const std::string& part : task_.scene_objects.parts()) {
    stage_.Hold(kRight, part);
    EXPECT_EQ(Sensed(), before) << part;
    stage_.LetGo(kRight, part);
  }
}

TEST_F(PredicateSensorTest, WhatDependsOnAPartThatIsNotTrackedIsUnknown) {
  stage_.SeatAll();
  stage_.StandAt("face_plate", 0.2, -0.4);
  const KeyFrame frame = stage_.Frame();
  for (const auto state : {Track::State::kFrozen, Track::State::kLost}) {
    Tracks tracks = stage_.AllTracked();
    for (Track& track : tracks.tracks) {
      if (track.name == "square_peg_1") track.state = state;
    }
    const State sensed =
        sensor_->Sense(SceneOf(frame, tracks, task_.scene_objects));
    EXPECT_EQ(In(sensed, "PegInHole(square_peg_1, base.square_1)"),
              Truth::kUnknown);
    EXPECT_EQ(In(sensed, "Clear(square_peg_1)"), Truth::kUnknown);
    EXPECT_EQ(In(sensed, "Horizontal(square_peg_1)"), Truth::kUnknown);
    EXPECT_EQ(In(sensed, "PegInHole(square_peg_2, base.square_2)"),
              Truth::kTrue);
    EXPECT_EQ(In(sensed, "Free(base.square_2)"), Truth::kFalse);
  }
}

TEST_F(PredicateSensorTest, AHoleThatALostPartMayBeInIsUnknown) {
  stage_.Remove("round_peg_1");
  const State state = Sensed();
  EXPECT_EQ(In(state, "Free(base.round_2)"), Truth::kUnknown);
  EXPECT_EQ(In(state, "Free(base.square_1)"), Truth::kTrue);
}

TEST_F(PredicateSensorTest, WithoutTracksEverythingIsUnknownThatAPartDecides) {
  const State state =
      sensor_->Sense(SceneOf(stage_.Frame(), Tracks{}, task_.scene_objects));
  EXPECT_EQ(In(state, "Clear(head)"), Truth::kUnknown);
  EXPECT_EQ(In(state, "Free(base.shaft)"), Truth::kUnknown);
  EXPECT_EQ(In(state, "PegInHole(shaft, base.shaft)"), Truth::kUnknown);
}

TEST(PredicateGeometry, ErrorsNameFileAndKey) {
  const PartTable parts = ShippedTask().parts;
  const auto load = [&](const std::string& predicates) {
    const Config config = Config::Parse(
        "types: {part: object, base_plate: part, round_peg: part, shaft: part,"
        " square_peg: part, separator: part, pendulum: part, head: part,"
        " face_plate: part, hole: object, round_hole: hole, shaft_hole: hole,"
        " square_hole: hole, separator_seat: hole, pendulum_seat: hole,"
        " head_seat: hole, face_plate_seat: hole}\n"
        "predicates:\n" +
            predicates,
        "d.yaml");
    const Vocabulary vocabulary = Vocabulary::FromConfig(config, parts);
    ReadGeometries(config, vocabulary, parts);
  };
  const auto error = [&](const std::string& predicates) -> std::string {
    try {
      load(predicates);
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_EQ(
      error("  P: {arguments: [shaft], geometry: {tilted: {over_deg: 9}}}"),
      "none");
  for (const char* bad :
       {"  P: {arguments: [shaft]}", "  P: {arguments: [shaft], geometry: {}}",
        "  P: {arguments: [shaft], geometry: {floats: {}}}",
        "  P: {arguments: [hole], geometry: {tilted: {over_deg: 9}}}",
        "  P: {arguments: [shaft], geometry: {tilted: {over_deg: 99}}}",
        "  P: {arguments: [shaft], geometry: {free_space: {above_mm: 9}}}",
        "  P: {arguments: [shaft, shaft], geometry: {seated: {z_mm: 1, xy_mm: "
        "1, tilt_deg: 1, yaw_deg: 1}}}",
        "  P: {arguments: [shaft], geometry: {seated: {site: base.nose, z_mm: "
        "1, xy_mm: 1, tilt_deg: 1, yaw_deg: 1}}}"}) {
    EXPECT_TRUE(error(bad).starts_with("d.yaml:predicates.P"))
        << bad << " gives " << error(bad);
  }
}

}  // namespace
}  // namespace cell
