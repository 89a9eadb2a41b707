// The kinematics of every kind of arm: forward and inverse undo each other.
#include "common/kinematics/arm_model.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "common/kinematics/arm_models.h"
#include "common/kinematics/joint_values.h"
#include "common/kinematics/ur_arm.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Joints RandomJoints(std::mt19937_64& random, double limit = kPi) {
  std::uniform_real_distribution<double> angle(-limit, limit);
  Joints q;
  for (int i = 0; i < kNumJoints; ++i) q[i] = angle(random);
  return q;
}

double Apart(const Joints& a, const Joints& b) {
  double apart = 0;
  for (int i = 0; i < kNumJoints; ++i) {
    apart = std::max(apart, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  }
  return apart;
}

class ArmModelTest : public testing::TestWithParam<std::string> {
 protected:
  const std::shared_ptr<const ArmModel> arm_ = FindArmModel(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Every, ArmModelTest,
                         testing::ValuesIn(ArmModelNames()),
                         [](const auto& model) { return model.param; });

TEST(ArmModels, AreFoundByName) {
  ASSERT_NE(FindArmModel("ur10e"), nullptr);
  EXPECT_EQ(FindArmModel("ur10e")->name(), "ur10e");
  EXPECT_EQ(FindArmModel("ur10e"), FindArmModel("ur10e"));
  EXPECT_EQ(FindArmModel("UR10e"), nullptr);
  EXPECT_EQ(FindArmModel(""), nullptr);
}

TEST_P(ArmModelTest, StandsAsItsTableSaysWhenAllAnglesAreZero) {
  const auto* ur = dynamic_cast<const UrArm*>(arm_.get());
  ASSERT_NE(ur, nullptr);
  const UrArm::Params& table = ur->params();
  const Isometry3d X_BF = arm_->FlangePose(Joints::Zero());
  EXPECT_NEAR(X_BF.translation().x(), table.a2 + table.a3, 1e-12);
  EXPECT_NEAR(X_BF.translation().y(), -table.d4 - table.d6, 1e-12);
  EXPECT_NEAR(X_BF.translation().z(), table.d1 - table.d5, 1e-12);
  EXPECT_TRUE(X_BF.linear().col(2).isApprox(-Vector3d::UnitY(), 1e-12));
}

TEST_P(ArmModelTest, EverySolutionReachesThePose) {
  std::mt19937_64 random(1);
  size_t most = 0;
  for (int i = 0; i < 5000; ++i) {
    const Isometry3d X_BF = arm_->FlangePose(RandomJoints(random));
    const auto solutions = arm_->SolveInverse(X_BF, Joints::Zero());
    most = std::max(most, solutions.size());
    for (const Joints& q : solutions) {
      ASSERT_TRUE(arm_->FlangePose(q).isApprox(X_BF, 1e-7)) << q.transpose();
    }
  }
  EXPECT_EQ(most, 8u);
}

TEST_P(ArmModelTest, TheSolutionsContainTheJointsThatThePoseCameFrom) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Joints q = RandomJoints(random);
    double nearest = 10;
    for (const Joints& solution :
         arm_->SolveInverse(arm_->FlangePose(q), Joints::Zero())) {
      nearest = std::min(nearest, Apart(solution, q));
    }
    ASSERT_LT(nearest, 1e-5) << q.transpose();
  }
}

TEST_P(ArmModelTest, EachSolutionOfARegularPoseIsAConfigurationOfItsOwn) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Joints q = RandomJoints(random);
    if (arm_->IsNearSingularity(q)) continue;
    const auto solutions =
        arm_->SolveInverse(arm_->FlangePose(q), Joints::Zero());
    for (size_t a = 0; a < solutions.size(); ++a) {
      for (size_t b = a + 1; b < solutions.size(); ++b) {
        if (arm_->IsNearSingularity(solutions[a]) ||
            arm_->IsNearSingularity(solutions[b]))
          continue;
        ASSERT_NE(arm_->ConfigurationOf(solutions[a]),
                  arm_->ConfigurationOf(solutions[b]));
      }
    }
  }
}

TEST_P(ArmModelTest, AStraightWristLeavesTheLastAngleToTheCaller) {
  Joints q;
  q << 0.3, -1.2, 1.1, -0.4, 0, 0.7;
  const auto solutions = arm_->SolveInverse(arm_->FlangePose(q), q);
  ASSERT_FALSE(solutions.empty());
  for (const Joints& solution : solutions) {
    EXPECT_TRUE(arm_->FlangePose(solution).isApprox(arm_->FlangePose(q), 1e-6));
  }
  EXPECT_TRUE(std::ranges::any_of(solutions, [&](const Joints& solution) {
    return Apart(solution, q) < 1e-6;
  }));
}

TEST_P(ArmModelTest, BeyondItsReachThereIsNoSolution) {
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() << 2.5, 0, 0.3;
  EXPECT_TRUE(arm_->SolveInverse(X_BF, Joints::Zero()).empty());
  X_BF.translation() << 0, 0.02, 0.3;  // inside the shoulder's column
  EXPECT_TRUE(arm_->SolveInverse(X_BF, Joints::Zero()).empty());
}

TEST_P(ArmModelTest, TheJacobianIsTheDerivativeOfThePose) {
  std::mt19937_64 random(4);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Joints q = RandomJoints(random);
    const ArmModel::JacobianMatrix J = arm_->Jacobian(q);
    for (int joint = 0; joint < 6; ++joint) {
      const Joints step = kStep * Joints::Unit(joint);
      const Isometry3d after = arm_->FlangePose(q + step);
      const Isometry3d before = arm_->FlangePose(q - step);
      const Eigen::AngleAxisd turned(after.linear() *
                                     before.linear().transpose());
      Eigen::Matrix<double, 6, 1> V;
      V << turned.axis() * turned.angle(),
          after.translation() - before.translation();
      ASSERT_LT((V / (2 * kStep) - J.col(joint)).norm(), 1e-6);
    }
  }
}

TEST_P(ArmModelTest, ManipulabilityIsTheDeterminantOfTheJacobian) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Joints q = RandomJoints(random);
    const auto& ur = dynamic_cast<const UrArm&>(*arm_);
    ASSERT_NEAR(ur.ManipulabilityOf(q).determinant,
                std::abs(arm_->Jacobian(q).determinant()), 1e-12);
  }
}

TEST_P(ArmModelTest, TheNearestCopyIsWithinTheLimitsAndHalfATurn) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 1000; ++i) {
    const Joints seed = RandomJoints(random, 2 * kPi);
    const Joints q = RandomJoints(random, 2 * kPi);
    const Joints near = arm_->NearestTo(seed, q);
    ASSERT_TRUE(arm_->IsWithinLimits(near));
    ASSERT_LT(Apart(near, q), 1e-9);
    for (int j = 0; j < 6; ++j) {
      if (std::abs(seed[j]) < kPi) {
        ASSERT_LE(std::abs(near[j] - seed[j]), kPi + 1e-9);
      }
    }
  }
}

TEST_P(ArmModelTest, NoAngleBeyondTheLimitsOrNotANumberIsWithinThem) {
  for (int i = 0; i < kNumJoints; ++i) {
    Joints q = Joints::Zero();
    EXPECT_TRUE(arm_->IsWithinLimits(q));
    q[i] = -1.001 * arm_->limits().angle[i];
    EXPECT_FALSE(arm_->IsWithinLimits(q));
    q[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(arm_->IsWithinLimits(q));
  }
}

TEST_P(ArmModelTest, IsReadyInTheOpenWithTheFlangeDown) {
  const Joints& ready = arm_->ready();
  EXPECT_FALSE(arm_->IsNearSingularity(ready));
  const Isometry3d X_BF = arm_->FlangePose(ready);
  EXPECT_NEAR(X_BF.linear()(2, 2), -1, 1e-9);
  const auto solution = arm_->SolveNear(X_BF, ready);
  ASSERT_TRUE(solution.has_value());
  EXPECT_LT((*solution - ready).norm(), 1e-9);
}

TEST_P(ArmModelTest, TheSolutionNearASeedKeepsItsConfiguration) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 1000; ++i) {
    const Joints seed = RandomJoints(random);
    if (arm_->IsNearSingularity(seed)) continue;
    const auto near = arm_->SolveNear(arm_->FlangePose(seed), seed);
    ASSERT_TRUE(near.has_value());
    ASSERT_LT((*near - seed).norm(), 1e-6);
  }
  Isometry3d far = Isometry3d::Identity();
  far.translation() << 2.5, 0, 0.3;
  EXPECT_FALSE(arm_->SolveNear(far, arm_->ready()).has_value());
}

TEST_P(ArmModelTest, ItsLeversReachAtLeastAsFarAsItsStretchedFlange) {
  const auto& table = dynamic_cast<const UrArm&>(*arm_).params();
  const Joints& levers = arm_->levers();
  EXPECT_GE(levers[0], std::abs(table.a2) + std::abs(table.a3));
  EXPECT_GE(levers[2], std::abs(table.a3) + table.d6);
  EXPECT_GE(levers[3], table.d5 + table.d6 + 0.2);  // and a hand
}

TEST_P(ArmModelTest, EveryLinkHasAHousing) {
  const auto& links = arm_->bodies().links;
  for (const auto& pieces : links) {
    EXPECT_FALSE(pieces.empty());
    for (const Piece& piece : pieces) {
      EXPECT_EQ(piece.kind, Piece::Kind::kCylinder);
      EXPECT_GT(piece.radius, 0.02);
      EXPECT_GT(piece.half_length, 0.01);
    }
  }
}

TEST(JointValues, OfAnotherNumberAreRefusedWithTheRightOne) {
  const ArmModel& arm = *FindArmModel("ur10e");
  EXPECT_EQ(JointsFromMessage(std::vector<double>(7), arm).reason(),
            "7 joints instead of the 6 of a ur10e");
  EXPECT_EQ(JointsFromMessage({}, arm).reason(),
            "0 joints instead of the 6 of a ur10e");
  EXPECT_TRUE(JointsFromMessage(std::vector<double>(6, 9.0), arm));
  EXPECT_EQ(AnglesFromMessage(std::vector<double>(6, 9.0), arm).reason(),
            "joints beyond the limits of a ur10e");
  EXPECT_TRUE(AnglesFromMessage(std::vector<double>(6, 1.0), arm));
}

TEST_P(ArmModelTest, NeighboursDoNotCollide) {
  for (size_t i = 0; i + 1 < ArmModel::kNumBodies; ++i) {
    EXPECT_FALSE(arm_->MayCollide(i, i + 1));
    EXPECT_EQ(arm_->MayCollide(0, i), arm_->MayCollide(i, 0));
  }
  EXPECT_TRUE(arm_->MayCollide(ArmModel::kBaseBody, ArmModel::kNumBodies));
}

}  // namespace
}  // namespace cell
