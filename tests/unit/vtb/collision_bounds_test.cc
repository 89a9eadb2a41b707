#include "services/vtb/collision_bounds.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <utility>

#include "services/vtb/world.h"

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;

/// Two plates of a slab with a hole, a peg that goes in, and a ball that
/// touches nothing but the table.
World MakeWorld() {
  const PartTable table = PartTable::FromConfig(Config::Parse(R"(
contacts:
  - [wall, peg]
  - [slab, slab]
  - [ball, table]
parts:
  plate_1: &plate
    type: plate
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces:
      - {kind: box, center: [60, 0, 0], size: [60, 90, 20], contact: slab}
      - {kind: hole, center: [0, 0], z: [-10, 10], apothem: 12, sides: 8, outer: 30, chamfer: [1, 1], contact: wall}
  plate_2: *plate
  peg:
    type: peg
    symmetry_order: 0
    density: 1000
    colour: [1, 1, 1]
    pieces:
      - {kind: cylinder, center: [0, 0, 0], axis: x, radius: 10, length: 80, contact: peg}
  block:
    type: block
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces:
      - {kind: box, center: [0, 0, 0], size: [40, 40, 40], contact: ball}
)",
                                                              "parts.yaml"));
  const std::string task = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";
  return World(table, CellLayout::FromConfig(Config::Load(task + "cell.yaml")),
               {.sleep = false});
}

class Bounds : public testing::Test {
 protected:
  Isometry3d Pose(double size) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double x = unit(random_), y = unit(random_), z = unit(random_);
    const double a = unit(random_), b = unit(random_), c = unit(random_);
    Isometry3d X(Eigen::Translation3d(size * x, size * y, 1 + size * z));
    X.linear() =
        Quaterniond(a, b, c, unit(random_)).normalized().toRotationMatrix();
    return X;
  }
  CollisionBounds BoundsOf(const std::string& part) {
    return {world_.model(),
            mj_name2id(&world_.model(), mjOBJ_BODY, part.c_str())};
  }

  std::mt19937_64 random_{7};
  World world_ = MakeWorld();
};

TEST_F(Bounds, EveryContactOfThePhysicsIsBetweenBodiesThatAreNear) {
  std::map<std::string, CollisionBounds> bounds;
  for (const Part& part : world_.table().parts()) {
    bounds.emplace(part.name, BoundsOf(part.name));
  }
  int num_contacts = 0;
  for (int scene = 0; scene < 300; ++scene) {
    for (const Part& part : world_.table().parts()) {
      world_.Place(part.name, Pose(0.06));
    }
    mj_kinematics(&world_.model(), &world_.data());
    mj_collision(&world_.model(), &world_.data());
    for (const BodyContact& contact : world_.Contacts()) {
      ++num_contacts;
      EXPECT_TRUE(bounds.at(contact.first)
                      .MayCollideWithin(0, world_.PoseOf(contact.first),
                                        bounds.at(contact.second),
                                        world_.PoseOf(contact.second)))
          << contact.first << ", " << contact.second;
    }
  }
  EXPECT_GT(num_contacts, 100);
}

TEST_F(Bounds, ClassesThatDoNotCollideAreNeverNear) {
  const CollisionBounds plate = BoundsOf("plate_1"), block = BoundsOf("block");
  const Isometry3d X = Pose(0.1);
  EXPECT_FALSE(plate.MayCollideWithin(0.1, X, block, X));
  EXPECT_TRUE(plate.MayBeWithin(0, X, {X, {0.01, 0.01, 0.01}}))
      << "but a hand notices every class";
}

TEST_F(Bounds, AHandIsNearFromTheGivenDistance) {
  const CollisionBounds peg = BoundsOf("peg");
  const Isometry3d X = Pose(0.1);
  // Before the peg's end, 20 mm away.
  const OrientedBox box{X * Eigen::Translation3d(0.07, 0, 0),
                        {0.01, 0.02, 0.03}};
  EXPECT_TRUE(peg.MayBeWithin(0.0201, X, box));
  EXPECT_FALSE(peg.MayBeWithin(0.0199, X, box));
}

TEST_F(Bounds, ItsReachIsThatOfItsFarthestCornerOrMore) {
  EXPECT_GE(BoundsOf("plate_1").reach(), std::hypot(0.09, 0.045, 0.01));
  EXPECT_LT(BoundsOf("plate_1").reach(), 0.13);
}

}  // namespace
}  // namespace cell::vtb
