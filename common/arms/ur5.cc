#include "common/arms/ur5.h"

#include <algorithm>
#include <cmath>

namespace cell::ur5 {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kTiny = 1e-9;

struct DhRow {
  double d, a, sin_alpha, cos_alpha;
};
constexpr std::array<DhRow, 6> kRows = {{{kD1, 0, 1, 0},
                                         {0, kA2, 0, 1},
                                         {0, kA3, 0, 1},
                                         {kD4, 0, 1, 0},
                                         {kD5, 0, -1, 0},
                                         {kD6, 0, 0, 1}}};

// Rz(angle) Tz(d) Tx(a) Rx(alpha).
Isometry3d DhTransform(const DhRow& row, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Isometry3d X = Isometry3d::Identity();
  X.linear() << c, -s * row.cos_alpha, s * row.sin_alpha,  //
      s, c * row.cos_alpha, -c * row.sin_alpha,            //
      0, row.sin_alpha, row.cos_alpha;
  X.translation() << row.a * c, row.a * s, row.d;
  return X;
}

// In [-pi, pi].
double Wrapped(double angle) {
  return std::remainder(angle, 2 * kPi);
}

// How far the wrist is in front of axis 1, in the plane that the arm moves in.
double ReachOf(const Joints& q) {
  return -kA2 * std::cos(q[1]) - kA3 * std::cos(q[1] + q[2]) -
         kD5 * std::sin(q[1] + q[2] + q[3]);
}

// The planar arm of links a2 and a3 that ends at `p` in frame 1 and turns by
// `sum` = q2 + q3 + q4: none, one or two solutions.
void SolvePlanar(const Vector3d& p, double sum, Joints q,
                 std::vector<Joints>* solutions) {
  const double square = p.x() * p.x() + p.y() * p.y();
  const double cosine = (square - kA2 * kA2 - kA3 * kA3) / (2 * kA2 * kA3);
  if (std::abs(cosine) > 1 + kTiny) return;
  const double elbow = std::acos(std::clamp(cosine, -1.0, 1.0));
  for (const double q3 : {elbow, -elbow}) {
    q[2] = q3;
    // p = (a2 + a3 e^{i q3}) e^{i q2}, in the plane's complex numbers.
    q[1] = Wrapped(std::atan2(p.y(), p.x()) -
                   std::atan2(kA3 * std::sin(q3), kA2 + kA3 * std::cos(q3)));
    q[3] = Wrapped(sum - q[1] - q[2]);
    solutions->push_back(q);
    if (elbow == 0) break;
  }
}

}  // namespace

std::array<Isometry3d, 6> LinkPoses(const Joints& q) {
  std::array<Isometry3d, 6> X;
  Isometry3d X_BL = Isometry3d::Identity();
  for (size_t i = 0; i < 6; ++i) {
    X_BL = X_BL * DhTransform(kRows[i], q[static_cast<int>(i)]);
    X[i] = X_BL;
  }
  return X;
}

Isometry3d FlangePose(const Joints& q) {
  return LinkPoses(q)[5];
}

JacobianMatrix Jacobian(const Joints& q) {
  const auto X = LinkPoses(q);
  const Vector3d p_BF = X[5].translation();
  JacobianMatrix J;
  Vector3d axis = Vector3d::UnitZ(), origin = Vector3d::Zero();
  for (int i = 0; i < 6; ++i) {  // joint i turns about z of the frame before
    J.col(i) << axis, axis.cross(p_BF - origin);
    axis = X[static_cast<size_t>(i)].linear().col(2);
    origin = X[static_cast<size_t>(i)].translation();
  }
  return J;
}

std::vector<Joints> SolveInverse(const Isometry3d& X_BF, double q6_if_free) {
  std::vector<Joints> solutions;
  const Matrix3d& R = X_BF.linear();
  const Vector3d p = X_BF.translation();
  const Vector3d p5 = p - kD6 * R.col(2);  // origin of frame 5
  // Seen from above p5 lies d4 beside the plane of axes 2, 3 and 4:
  // p5.x sin q1 - p5.y cos q1 = d4.
  const double rho = std::hypot(p5.x(), p5.y());
  if (rho < kD4 - kTiny || rho == 0) return solutions;
  const double azimuth = std::atan2(p5.y(), p5.x());
  const double side = std::asin(std::min(kD4 / rho, 1.0));
  Joints q = Joints::Zero();
  for (const double q1 : {azimuth + side, azimuth + kPi - side}) {
    q[0] = Wrapped(q1);
    const double s1 = std::sin(q1), c1 = std::cos(q1);
    const Vector3d z1(s1, -c1, 0);
    // z6 . z1 = cos q5
    const double cosine = std::clamp(R.col(2).dot(z1), -1.0, 1.0);
    const double wrist = std::atan2((R.col(2) - cosine * z1).norm(), cosine);
    for (const double q5 : {wrist, -wrist}) {
      q[4] = q5;
      const double s5 = std::sin(q5);
      const bool is_free = std::abs(s5) < 1e-7;
      // x6 . z1 = s5 c6 and y6 . z1 = -s5 s6
      q[5] = is_free
                 ? q6_if_free
                 : std::atan2(-R.col(1).dot(z1) / s5, R.col(0).dot(z1) / s5);
      const Isometry3d X_46 =
          DhTransform(kRows[4], q5) * DhTransform(kRows[5], q[5]);
      const Isometry3d X_14 =
          DhTransform(kRows[0], q1).inverse() * X_BF * X_46.inverse();
      // x4 in frame 1 is (cos, sin, 0) of q2 + q3 + q4; origin 4 lies d4 along
      // z1 from origin 3.
      const double sum = std::atan2(X_14(1, 0), X_14(0, 0));
      SolvePlanar(X_14.translation(), sum, q, &solutions);
      if (is_free) break;
    }
    if (rho <= kD4) break;
  }
  return solutions;
}

Joints NearestTo(const Joints& seed, const Joints& q) {
  constexpr double kTurn = 2 * kPi;
  Joints nearest = q;
  for (int i = 0; i < 6; ++i) {
    double& angle = nearest[i];
    angle += kTurn * std::round((seed[i] - angle) / kTurn);
    if (angle > kJointLimit) angle -= kTurn;
    if (angle < -kJointLimit) angle += kTurn;
  }
  return nearest;
}

bool IsWithinLimits(const Joints& q) {
  return LimitMargin(q) >= 0;
}

double LimitMargin(const Joints& q) {
  return kJointLimit - q.cwiseAbs().maxCoeff();
}

Branch BranchOf(const Joints& q) {
  return {ReachOf(q) < 0, std::sin(q[2]) < 0, std::sin(q[4]) < 0};
}

Regularity RegularityOf(const Joints& q) {
  Regularity regularity;
  regularity.elbow = std::sin(q[2]);
  regularity.wrist = std::sin(q[4]);
  regularity.reach = ReachOf(q);
  regularity.determinant = std::abs(kA2 * kA3 * regularity.elbow *
                                    regularity.wrist * regularity.reach);
  regularity.wrist_distance = std::hypot(kD4, regularity.reach);
  return regularity;
}

bool IsRegular(const Joints& q, const RegularityBounds& bounds) {
  const Regularity regularity = RegularityOf(q);
  return std::abs(regularity.elbow) > bounds.min_sine &&
         std::abs(regularity.wrist) > bounds.min_sine &&
         regularity.determinant > bounds.min_determinant &&
         regularity.wrist_distance > bounds.min_wrist_distance;
}

}  // namespace cell::ur5
