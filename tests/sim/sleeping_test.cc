// Parts that sleep against the same parts kept awake: what happens is the same,
// and at the same time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "services/vtb/world.h"
#include "tests/sim/cranfield_world.h"

namespace cell {

using namespace vtb;
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::IsEmpty;

constexpr char kHand[] = "hand_right";
constexpr int kStepsPerTick = 8;
constexpr double kTick = 0.008;  // [s]

Isometry3d Shifted(Isometry3d X, const Vector3d& by) {
  X.translation() += by;
  return X;
}

/// The same scene twice: parts at rest sleep in one, all are awake in the
/// other. Parts that a test does not use stand well apart.
class Sleeping : public testing::Test {
 protected:
  Sleeping() {
    const std::vector<std::string> parts{
        "round_peg_1", "round_peg_2", "square_peg_1", "square_peg_2", "shaft"};
    for (size_t i = 0; i < parts.size(); ++i) {
      Place(parts[i], Upright(-0.6 + 0.1 * static_cast<double>(i), 0.6, 0.045));
    }
    Place("separator", Upright(-0.6, 0.8, 0));
    Place("pendulum", Upright(0, 0.8, 0));
    Place("head", Upright(0.2, 0.8, 0));
    Place("face_plate", Upright(0.6, 0.8, 0));
  }

  std::vector<World*> Both() { return {&world_, &awake_}; }
  void Place(const std::string& part, const Isometry3d& X_WO) {
    for (World* world : Both()) world->Place(part, X_WO);
  }
  void Seat(const std::string& part, const std::string& site_name) {
    for (World* world : Both()) cell::Seat(*world, part, site_name);
  }
  void SeatAll() {
    for (World* world : Both()) cell::SeatAll(*world);
  }
  void Run(int num_steps) {
    for (World* world : Both()) world->Run(num_steps);
  }
  /// Grips a part of both worlds where it is.
  void Grip(const std::string& hand, const std::string& part) {
    for (World* world : Both()) {
      world->hands().Place(hand, world->PoseOf(part), 0.01);
      world->hands().Grip(hand, part);
    }
  }
  /// One tick, in which the hand moves by so much.
  void Move(const std::string& hand, const Vector3d& by) {
    for (World* world : Both()) {
      const Isometry3d X_WG = world->hands().StateOf(hand).X_WG;
      world->hands().Move(hand, Shifted(X_WG, by), 0.01);
      world->Run(kStepsPerTick);
    }
  }
  /// [m] Between where a part is in the two worlds.
  double Difference(const std::string& part) {
    const Isometry3d a = world_.PoseOf(part), b = awake_.PoseOf(part);
    return (a.translation() - b.translation()).norm() +
           0.1 * AngleAxisd(a.linear().transpose() * b.linear()).angle();
  }
  std::set<std::string> Asleep() const { return AsleepIn(world_); }
  static std::set<std::string> AsleepIn(const World& world) {
    std::set<std::string> names;
    for (const Part& part : world.table().parts()) {
      if (world.IsAsleep(part.name)) names.insert(part.name);
    }
    return names;
  }
  void ExpectAllAsleep() const {
    EXPECT_EQ(Asleep().size(), world_.table().parts().size() - 1)
        << "all but the fixed base";
  }
  static double Height(const World& world, const std::string& part) {
    return world.PoseOf(part).translation().z();
  }
  static double DeepestContact(const World& world) {
    double depth = 0;
    for (const BodyContact& contact : world.Contacts()) {
      if (contact.first.starts_with("hand")) continue;
      depth = std::max(depth, -contact.distance);
    }
    return depth;
  }
  /// [m] That a part moves at most if all wake now.
  double ShiftIfAwake() {
    awake_.Restore(world_.Save());
    awake_.Run(500);
    double shift = 0;
    for (const Part& part : world_.table().parts()) {
      shift = std::max(shift, Difference(part.name));
    }
    return shift;
  }

  World world_ = MakeWorld({.sleep = true});
  World awake_ = MakeWorld({.sleep = false});
};

bool AreSame(const std::vector<BodyPose>& a, const std::vector<BodyPose>& b) {
  return std::ranges::equal(a, b, [](const BodyPose& p, const BodyPose& q) {
    return p.name == q.name && p.X_WB.matrix() == q.X_WB.matrix();
  });
}

TEST_F(Sleeping, PartsAtRestFallAsleepAndKeepTheirPosesBitForBit) {
  Run(1000);
  ExpectAllAsleep();
  const std::vector<BodyPose> before = world_.Bodies();
  Run(1000);
  EXPECT_TRUE(AreSame(before, world_.Bodies()));
  EXPECT_NEAR(world_.time(), awake_.time(), 1e-12);
}

TEST_F(Sleeping, NothingSleepsInAWorldThatKeepsAllAwake) {
  Run(1000);
  EXPECT_THAT(AsleepIn(awake_), IsEmpty());
}

TEST_F(Sleeping, AnAssemblySleepsToo) {
  SeatAll();
  Run(1500);
  ExpectAllAsleep();
  EXPECT_LT(ShiftIfAwake(), 2e-5);
}

TEST_F(Sleeping, ContactsOfSleepingPartsAreReported) {
  Place("separator", Upright(0.6, 0.8, 0.03));  // on the face plate
  Run(1000);
  ExpectAllAsleep();
  const auto contacts = world_.Contacts(), expected = awake_.Contacts();
  ASSERT_EQ(contacts.size(), expected.size());
  for (size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(contacts[i].first, expected[i].first);
    EXPECT_EQ(contacts[i].second, expected[i].second);
    EXPECT_NEAR(contacts[i].normal_force, expected[i].normal_force,
                0.01 * expected[i].normal_force);
    EXPECT_NEAR(contacts[i].distance, expected[i].distance, 1e-5);
  }
}

TEST_F(Sleeping, WhatHasLostItsSupportFallsAtOnce) {
  Place("pendulum", Upright(0.6, 0.75, 0.03));
  Run(1000);
  ExpectAllAsleep();
  Place("face_plate", Upright(-0.2, 0.3, 0));
  for (int step = 0; step < 300; ++step) {
    Run(1);
    ASSERT_LT(Difference("pendulum"), 2e-5) << step;
  }
  EXPECT_LT(Height(world_, "pendulum"), 1e-3);
}

TEST_F(Sleeping, ATowerSinksWhenItsLowestPartIsPulledAway) {
  Place("pendulum", Upright(0.6, 0.75, 0.03));
  Place("separator", Upright(0.6, 0.75, 0.06));
  Run(1000);
  ExpectAllAsleep();
  Grip(kHand, "face_plate");
  for (int tick = 0; tick < 60; ++tick) {
    Move(kHand, Vector3d(-0.004, 0, 0));  // 0.5 m/s
    ASSERT_THAT(Asleep(), testing::Not(testing::Contains("separator")));
    ASSERT_LT(
        std::abs(Height(world_, "separator") - Height(awake_, "separator")),
        1e-3)
        << tick;
  }
  for (World* world : Both()) world->hands().Release(kHand);
  Run(2500);
  ExpectAllAsleep();
  EXPECT_LT(ShiftIfAwake(), 1e-4);
}

TEST_F(Sleeping, WhatStandsOnEdgeIsToppledByAHeldPart) {
  const Isometry3d on_edge =
      Upright(-0.6, 0.3, 0.035) *
      Isometry3d(AngleAxisd(std::acos(-1) / 2, Vector3d::UnitX()));
  Place("separator", on_edge);
  Place("pendulum", Upright(-0.6, 0.0, 0.05));
  Grip(kHand, "pendulum");
  Run(1000);
  ASSERT_TRUE(world_.IsAsleep("separator"));
  ASSERT_FALSE(world_.IsAsleep("pendulum"));
  // The bar of the pendulum pushes it over at 0.25 m/s.
  const auto upright = [](const World& world) {
    return std::abs(world.PoseOf("separator").linear()(1, 2));
  };
  for (int tick = 0; tick < 40; ++tick) {
    Move(kHand, Vector3d(0, 0.002, 0));
    // Where it falls to once it tilts by more is a matter of micrometres.
    if (upright(awake_) < 0.995) continue;
    ASSERT_LT(Difference("separator"), 1e-4) << tick;
  }
  for (int tick = 0; tick < 100; ++tick) Move(kHand, Vector3d::Zero());
  EXPECT_LT(upright(world_), 0.2) << "it has fallen";
  EXPECT_LT(upright(awake_), 0.2);
}

TEST_F(Sleeping, APartIsPushedSlowlyAsIfItHadNeverSlept) {
  Place("separator", Upright(-0.5, 0.3, 0));
  Place("pendulum", Upright(-0.5, 0.05, 0.004));
  Grip(kHand, "pendulum");
  Run(1000);
  ASSERT_TRUE(world_.IsAsleep("separator"));
  double pushed = 0;
  for (int tick = 0; tick < 750; ++tick) {
    Move(kHand, Vector3d(0, 4e-5, 0));  // 5 mm/s
    ASSERT_LT(Difference("separator"), 2e-4) << tick;
    ASSERT_LT(DeepestContact(world_), 3e-4) << tick;
    pushed = world_.PoseOf("separator").translation().y() - 0.3;
  }
  EXPECT_GT(pushed, 0.005);
}

TEST_F(Sleeping, AFastPartDoesNotPassThroughASleepingOne) {
  Place("separator", Upright(-0.5, 0.3, 0));
  Place("pendulum", Upright(-0.5, -0.35, 0.004));
  Grip(kHand, "pendulum");
  Run(1000);
  ASSERT_TRUE(world_.IsAsleep("separator"));
  for (int tick = 0; tick < 60; ++tick) {
    Move(kHand, Vector3d(0, 0.012, 0));  // 1.5 m/s
    ASSERT_LT(std::abs(world_.PoseOf("separator").translation().y() -
                       awake_.PoseOf("separator").translation().y()),
              0.01)
        << tick;
  }
  EXPECT_GT(world_.PoseOf("separator").translation().y(), 0.6);
}

TEST_F(Sleeping, APartLandsOnASleepingOne) {
  Run(1000);
  Place("separator", Upright(0.6, 0.8, 0.25));
  for (int step = 0; step < 1000; ++step) {
    Run(1);
    ASSERT_LT(DeepestContact(world_), DeepestContact(awake_) + 2e-4) << step;
    ASSERT_NEAR(Height(world_, "separator"), Height(awake_, "separator"), 1e-3)
        << step;
  }
  EXPECT_NEAR(Height(world_, "separator"), 0.03, 1e-4);
  EXPECT_NEAR(Height(world_, "face_plate"), 0, 1e-4);
}

TEST_F(Sleeping, AHandThatHoversAndTouchesIsNoticedAtTheSameTime) {
  Run(1000);
  const Isometry3d X_WO = world_.PoseOf("shaft");
  const auto place = [&](double above) {
    return Shifted(X_WO, Vector3d(0, 0, 0.045 + above));
  };
  for (World* world : Both()) {
    world->hands().Place(kHand, place(0.05), 0.01);
  }
  Run(1000);
  EXPECT_TRUE(world_.IsAsleep("shaft"));
  const auto touches = [](const World& world) {
    return std::ranges::any_of(world.Contacts(), [](const auto& contact) {
      return contact.first == "hand_right.thumb" && contact.second == "shaft";
    });
  };
  bool has_touched = false;
  // Down for 1.6 s, still for 0.8 s, up again.
  for (int tick = 0; tick < 500; ++tick) {
    const double to = tick < 200   ? 0.05 - 0.0003 * tick
                      : tick < 300 ? -0.01
                                   : -0.01 + 0.0003 * (tick - 300);
    for (World* world : Both()) {
      world->hands().Move(kHand, place(to), 0.01);
      world->Run(kStepsPerTick);
    }
    ASSERT_EQ(touches(world_), touches(awake_)) << tick;
    if (touches(world_) && (tick < 200 || tick >= 301)) {
      EXPECT_FALSE(world_.IsAsleep("shaft")) << tick;
      has_touched = true;
    }
    if (tick == 299) {
      EXPECT_TRUE(world_.IsAsleep("shaft")) << "nothing moves";
      EXPECT_TRUE(touches(world_));
    }
  }
  EXPECT_TRUE(has_touched);
  EXPECT_TRUE(world_.IsAsleep("shaft")) << "the hand has gone";
}

TEST_F(Sleeping, ASeatedPartIsPulledOut) {
  Seat("square_peg_1", "base.square_1");
  Run(1000);
  ExpectAllAsleep();
  Grip(kHand, "square_peg_1");
  for (int tick = 0; tick < 100; ++tick) {
    Move(kHand, Vector3d(0, 0, 0.0008));  // 0.1 m/s
    ASSERT_FALSE(world_.IsAsleep("square_peg_1"));
    ASSERT_LT(Difference("square_peg_1"), 5e-5) << tick;
  }
}

TEST_F(Sleeping, WhatIsScrewedOnMovesWithItsHost) {
  Seat("shaft", "base.shaft");
  Seat("pendulum", "base.pendulum");
  Seat("head", "pendulum.head");
  Run(1500);
  ExpectAllAsleep();
  ASSERT_TRUE(world_.IsOnThread("pendulum.head", "head"));
  const Isometry3d X_PH =
      world_.PoseOf("pendulum").inverse() * world_.PoseOf("head");
  Grip(kHand, "pendulum");
  for (int tick = 0; tick < 100; ++tick) {
    Move(kHand, Vector3d(0, 0, 0.0008));
    ASSERT_FALSE(world_.IsAsleep("head"));
    ASSERT_LT(Difference("head"), 2e-4) << tick;
  }
  const Isometry3d now =
      world_.PoseOf("pendulum").inverse() * world_.PoseOf("head");
  EXPECT_LT((now.translation() - X_PH.translation()).norm(), 5e-4);
}

TEST_F(Sleeping, AnArmFeelsASleepingAssemblyLikeOneThatIsAwake) {
  const std::string gripper = world_.layout().arms.front().gripper;
  SeatAll();
  Place("face_plate", Upright(0, 0, 0.3));
  const Site& site = *world_.table().FindSite("base.face_plate");
  Place("face_plate",
        Shifted(world_.PoseOf("base") * site.X_HS, Vector3d(0, 0, 0.05)));
  Grip(gripper, "face_plate");
  Run(1000);
  ASSERT_EQ(Asleep().size(), world_.table().parts().size() - 2);
  double largest = 0;
  for (int tick = 0; tick < 260; ++tick) {
    // Down to 2 mm below the seat, at 25 mm/s.
    Move(gripper, Vector3d(0, 0, tick < 250 ? -0.000208 : 0));
    const double force = world_.hands().WrenchOn(gripper).force.z();
    const double expected = awake_.hands().WrenchOn(gripper).force.z();
    largest = std::max(largest, force);
    ASSERT_NEAR(force, expected, 0.1 + 0.05 * std::abs(expected)) << tick;
    ASSERT_LT(Difference("face_plate"), 1e-4) << tick;
  }
  EXPECT_GT(largest, 20) << "it presses";
}

TEST_F(Sleeping, PartsThatFallAnyhowAreNeverLeftInTheAir) {
  const std::vector<std::string> parts{"separator", "pendulum", "face_plate",
                                       "square_peg_1", "head"};
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] {
      const double x = unit(random), y = unit(random);
      return Vector3d(x, y, unit(random));
    };
    double height = 0.2;
    for (const std::string& part : parts) {
      const Vector3d turn = 3 * vector();
      Place(part,
            Shifted(Isometry3d(AngleAxisd(turn.norm(), turn.normalized())),
                    0.1 * vector() + Vector3d(-0.5, -0.8, height)));
      height += 0.2;
    }
    for (int step = 0; step < 8000; step += 8) {
      world_.Run(kStepsPerTick);
      ASSERT_LT(DeepestContact(world_), 0.02) << seed << " at " << step;
    }
    EXPECT_GE(Asleep().size(), 5u) << seed;
    EXPECT_LT(ShiftIfAwake(), 5e-4) << seed;
  }
}

// An upright part tilted to just short of the point where it falls over, and
// just beyond.
TEST_F(Sleeping, APartThatIsAboutToFallOverDoesNotFallAsleep) {
  const double balance = std::atan2(10.5, 45.0);  // [rad] of the foot's edge
  for (const double tilt : {-0.02, -0.002, -2e-4, 2e-4, 0.002, 0.02}) {
    const double angle = balance + tilt;
    // The lower edge of the foot stays on the table.
    const Vector3d p(0.045 * std::sin(angle) - 0.0105 * std::cos(angle), 0,
                     0.045 * std::cos(angle) + 0.0105 * std::sin(angle));
    Place("round_peg_1",
          Shifted(Isometry3d(AngleAxisd(angle, Vector3d::UnitY())),
                  p + Vector3d(-0.5, 0.3, 0)));
    Run(3000);
    const double up = world_.PoseOf("round_peg_1").linear()(2, 2);
    EXPECT_NEAR(up, awake_.PoseOf("round_peg_1").linear()(2, 2), 0.01) << tilt;
    EXPECT_TRUE(up > 0.99 || up < 0.1) << tilt << ": " << up;
  }
}

TEST_F(Sleeping, ASnapshotTakenInMidSleepContinuesBitForBit) {
  SeatAll();
  Place("face_plate", Upright(0.6, 0.8, 0));
  Place("separator", Upright(0.6, 0.8, 0.03));
  world_.Run(1500);
  world_.Place("pendulum", Upright(0.1, -0.5, 0.2));
  world_.Run(40);
  ASSERT_FALSE(world_.IsAsleep("pendulum")) << "it falls";
  ASSERT_GE(Asleep().size(), 6u);
  const World::Snapshot snapshot = world_.Save();
  const auto go_on = [](World& world) {
    world.Run(600);
    world.hands().Place(kHand, world.PoseOf("face_plate"), 0.01);
    world.hands().Grip(kHand, "face_plate");
    for (int tick = 0; tick < 60; ++tick) {
      const Isometry3d X_WG = world.hands().StateOf(kHand).X_WG;
      world.hands().Move(kHand, Shifted(X_WG, Vector3d(0.003, 0, 1e-4)), 0.01);
      world.Run(kStepsPerTick);
    }
    world.hands().Release(kHand);
    world.Run(800);
  };
  go_on(world_);
  const std::vector<BodyPose> first = world_.Bodies();
  const std::set<std::string> asleep = Asleep();

  world_.Restore(snapshot);
  go_on(world_);
  EXPECT_TRUE(AreSame(first, world_.Bodies()));
  EXPECT_EQ(Asleep(), asleep);

  World other = MakeWorld({.sleep = true});
  other.Restore(snapshot);
  go_on(other);
  EXPECT_TRUE(AreSame(first, other.Bodies()));
}

TEST_F(Sleeping, ARestoredWorldReportsContactsOfSleepingParts) {
  Run(1000);
  World other = MakeWorld({.sleep = true});
  other.Restore(world_.Save());
  const auto contacts = world_.Contacts(), restored = other.Contacts();
  ASSERT_EQ(contacts.size(), restored.size());
  for (size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(contacts[i].second, restored[i].second);
    EXPECT_EQ(contacts[i].normal_force, restored[i].normal_force);
  }
}

TEST_F(Sleeping, ResetWakesAll) {
  Run(1000);
  ExpectAllAsleep();
  world_.Reset();
  EXPECT_THAT(Asleep(), IsEmpty());
  for (const Part& part : world_.table().parts()) {
    if (!part.is_fixed) world_.Place(part.name, Upright(0, 1, 1));
  }
  world_.Run(100);
  EXPECT_LT(Height(world_, "head"), 0.97) << "it falls";
}

}  // namespace
}  // namespace cell
