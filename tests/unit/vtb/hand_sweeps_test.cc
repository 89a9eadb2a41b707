#include "services/vtb/hand_sweeps.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "services/vtb/world.h"

namespace cell::vtb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

class HandSweeps : public testing::Test {
 protected:
  Vector3d Vector(double size) {
    std::uniform_real_distribution<double> range(-size, size);
    const double x = range(random_), y = range(random_);
    return {x, y, range(random_)};
  }
  Isometry3d Moved(const Isometry3d& X, double distance, double angle) {
    const Vector3d turn = Vector(angle);
    Isometry3d moved = X;
    moved.translation() += Vector(distance);
    moved.linear() =
        AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() *
        X.linear();
    return moved;
  }
  /// [m] That a corner of a box has moved at most.
  static double Moved(const OrientedBox& from, const Isometry3d& X_WB) {
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                          corner & 4 ? 1 : -1);
      const Vector3d p_B = from.half_extents.cwiseProduct(sign);
      distance = std::max(distance, (X_WB * p_B - from.X_AB * p_B).norm());
    }
    return distance;
  }

  std::mt19937_64 random_{11};
  const std::string task_ = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";
  const CellLayout layout_ =
      CellLayout::FromConfig(Config::Load(task_ + "cell.yaml"));
  const PartTable parts_ =
      PartTable::FromConfig(Config::Load(task_ + "parts.yaml"));
  World world_{parts_, layout_, {}};
};

TEST_F(HandSweeps, NoBoxGoesFurtherThanItsTravel) {
  for (int run = 0; run < 200; ++run) {
    for (const CellLayout::NamedHand& hand : layout_.AllHands()) {
      const double size = run % 2 == 0 ? 0.01 : 0.2;
      const Hands::State& state = world_.hands().StateOf(hand.name);
      const auto& grips = hand.type->grips;
      world_.hands().PlaceFingers(
          hand.name, grips[static_cast<size_t>(run) % grips.size()].name);
      world_.hands().Move(hand.name, Moved(state.X_WG, size, 10 * size),
                          0.02 + 0.001 * (run % 30));
    }
    const std::vector<HandSweep> sweeps = SweepsOf(layout_, world_.hands());
    for (int step = 1; step <= 8; ++step) {
      world_.hands().BeforeStep(step / 8.0, 0.008);
      const std::vector<BodyPose> bodies = world_.hands().Bodies();
      ASSERT_EQ(bodies.size(), sweeps.size());
      for (size_t i = 0; i < bodies.size(); ++i) {
        ASSERT_LE(Moved(sweeps[i].box, bodies[i].X_WB),
                  sweeps[i].travel + 1e-12)
            << bodies[i].name << " in run " << run;
      }
    }
    world_.hands().AfterRun();
  }
}

TEST_F(HandSweeps, AHandAtRestDoesNotTravel) {
  double x = 2;  // all parts begin at one place, where they would collide
  for (const Part& part : parts_.parts()) {
    if (!part.is_free()) continue;
    world_.Place(part.name, Isometry3d(Eigen::Translation3d(x += 0.5, 0, 0)));
  }
  world_.Run(8);
  for (const HandSweep& sweep : SweepsOf(layout_, world_.hands())) {
    EXPECT_LT(sweep.travel, 1e-12);
  }
}

}  // namespace
}  // namespace cell::vtb
