#include "common/arms/ur5.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell::ur5 {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kD1 = 0.089159, kD4 = 0.10915, kD5 = 0.09465, kD6 = 0.0823;
constexpr double kA2 = -0.425, kA3 = -0.39225;
constexpr std::array<double, 6> kD = {kD1, 0, 0, kD4, kD5, kD6};
constexpr std::array<double, 6> kA = {0, kA2, kA3, 0, 0, 0};
constexpr std::array<double, 6> kAlpha = {kPi / 2, 0, 0, kPi / 2, -kPi / 2, 0};
constexpr double kExact = 1e-6;  // [m], [rad] of an inverse

/// X from the link before joint i to the link behind it.
Isometry3d LinkStep(size_t i, double angle) {
  return Isometry3d(AngleAxisd(angle, Vector3d::UnitZ())) *
         Translation3d(kA[i], 0, kD[i]) *
         AngleAxisd(kAlpha[i], Vector3d::UnitX());
}

double Wrapped(double angle) {
  return std::remainder(angle, 2 * kPi);
}

bool IsSame(const Isometry3d& X, const Isometry3d& Y) {
  return (X.matrix() - Y.matrix()).cwiseAbs().maxCoeff() < kExact;
}

/// Joints 2 to 4 for the rest, which is a planar arm of two links.
void SolvePlane(const Isometry3d& X_BF, double q1, double q5, double q6,
                std::vector<Joints>& solutions) {
  const Isometry3d X_14 = LinkStep(0, q1).inverse() * X_BF *
                          (LinkStep(4, q5) * LinkStep(5, q6)).inverse();
  const Vector3d p = X_14 * Vector3d(0, -kD4, 0);
  const double reach2 = p.x() * p.x() + p.y() * p.y();
  const double cos3 = (reach2 - kA2 * kA2 - kA3 * kA3) / (2 * kA2 * kA3);
  if (std::abs(cos3) > 1 + 1e-12) return;
  const double elbow = std::acos(std::clamp(cos3, -1.0, 1.0));
  for (const double q3 : {elbow, -elbow}) {
    const double q2 = std::atan2(p.y(), p.x()) -
                      std::atan2(kA3 * std::sin(q3), kA2 + kA3 * std::cos(q3));
    const Isometry3d X_34 =
        (LinkStep(1, q2) * LinkStep(2, q3)).inverse() * X_14;
    const double q4 = std::atan2(X_34(1, 0), X_34(0, 0));
    Joints q;
    q << Wrapped(q1), Wrapped(q2), Wrapped(q3), Wrapped(q4), Wrapped(q5),
        Wrapped(q6);
    if (IsSame(FlangePose(q), X_BF)) solutions.push_back(q);
  }
}

}  // namespace

std::array<Isometry3d, 6> LinkPoses(const Joints& q) {
  std::array<Isometry3d, 6> poses;
  Isometry3d X = Isometry3d::Identity();
  for (size_t i = 0; i < 6; ++i) {
    X = X * LinkStep(i, q[static_cast<Eigen::Index>(i)]);
    poses[i] = X;
  }
  return poses;
}

Isometry3d FlangePose(const Joints& q) {
  return LinkPoses(q)[5];
}

Eigen::Matrix<double, 6, 6> Jacobian(const Joints& q) {
  const auto poses = LinkPoses(q);
  const Vector3d p = poses[5].translation();
  Eigen::Matrix<double, 6, 6> J;
  Vector3d axis = Vector3d::UnitZ(), origin = Vector3d::Zero();
  for (int i = 0; i < 6; ++i) {
    J.block<3, 1>(0, i) = axis;
    J.block<3, 1>(3, i) = axis.cross(p - origin);
    axis = poses[static_cast<size_t>(i)].linear().col(2);
    origin = poses[static_cast<size_t>(i)].translation();
  }
  return J;
}

std::vector<Joints> Inverse(const Isometry3d& X_BF) {
  std::vector<Joints> solutions;
  const Eigen::Matrix3d R = X_BF.linear();
  const Vector3d p = X_BF.translation();
  const Vector3d wrist = p - kD6 * R.col(2);  // origin of frame 5
  const double radius = wrist.head<2>().norm();
  if (radius < kD4) return solutions;
  const double towards = std::atan2(wrist.y(), wrist.x());
  const double beside = std::acos(std::min(1.0, kD4 / radius));
  for (const double q1 :
       {towards + beside + kPi / 2, towards - beside + kPi / 2}) {
    const double s1 = std::sin(q1), c1 = std::cos(q1);
    const double cos5 = (p.x() * s1 - p.y() * c1 - kD4) / kD6;
    if (std::abs(cos5) > 1 + 1e-12) continue;
    const double fold = std::acos(std::clamp(cos5, -1.0, 1.0));
    for (const double q5 : {fold, -fold}) {
      const double s5 = std::sin(q5);
      // With joints 4 and 6 in line any split of their sum will do.
      const double q6 = std::abs(s5) < 1e-9
                            ? 0
                            : std::atan2((-R(0, 1) * s1 + R(1, 1) * c1) / s5,
                                         (R(0, 0) * s1 - R(1, 0) * c1) / s5);
      SolvePlane(X_BF, q1, q5, q6, solutions);
    }
  }
  return solutions;
}

Joints Nearest(const Joints& q, const Joints& seed) {
  Joints nearest;
  for (int i = 0; i < 6; ++i) {
    double angle = seed[i] + Wrapped(q[i] - seed[i]);
    if (angle > kJointLimit) angle -= 2 * kPi;
    if (angle < -kJointLimit) angle += 2 * kPi;
    nearest[i] = angle;
  }
  return nearest;
}

std::optional<Joints> InverseNear(const Isometry3d& X_BF, const Joints& seed,
                                  double max_step) {
  std::optional<Joints> best;
  double least = max_step;
  for (const Joints& solution : Inverse(X_BF)) {
    const Joints q = Nearest(solution, seed);
    const double step = (q - seed).cwiseAbs().maxCoeff();
    if (step > least) continue;
    least = step;
    best = q;
  }
  return best;
}

double Dexterity(const Joints& q) {
  constexpr double kFarFromShoulder = 0.46;
  const double wrist =
      LinkPoses(q)[4].translation().head<2>().norm() / kFarFromShoulder;
  return std::min({std::abs(std::sin(q[2])), std::abs(std::sin(q[4])), wrist});
}

}  // namespace cell::ur5
