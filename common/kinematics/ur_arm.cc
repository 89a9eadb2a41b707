#include "common/kinematics/ur_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kTiny = 1e-9;

// What a UR5 keeps from its singularities; lengths scale with the arm.
constexpr double kUr5A3 = 0.39225, kUr5Reach = 0.425 + kUr5A3;         // [m]
constexpr double kUr5D4 = 0.10915, kUr5D5 = 0.09465, kUr5D6 = 0.0823;  // [m]
constexpr double kMinSine = 0.26;           // |sin q3|, |sin q5|: 15 deg
constexpr double kUr5Determinant = 0.010;   // [m^3]
constexpr double kUr5WristDistance = 0.12;  // [m]

// [m] of a UR5's fingertips about each axis
Joints Ur5Levers() {
  return Joints{{0.90, 0.90, 0.75, 0.45, 0.40, 0.15}};
}

// [m] of a UR5's housings: what its datasheet draws, rounded up.
constexpr double kUr5Base = 0.075, kShoulder = 0.060, kUpperArm = 0.058,
                 kForearm = 0.050, kWrist = 0.046;

enum class Axis { kX, kY, kZ };

// From `low` to `high` along an axis through `centre`.
Piece Cylinder(Axis axis, double radius, double low, double high,
               const Vector3d& centre = Vector3d::Zero()) {
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.radius = radius;
  piece.half_length = (high - low) / 2;
  const Vector3d along = Vector3d::Unit(static_cast<int>(axis));
  piece.X_OP.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along)
          .toRotationMatrix();
  piece.X_OP.translation() = centre + along * (low + high) / 2;
  return piece;
}

// Frame 1: z along axis 2, y up. Frames 2 and 3: z along axes 3 and 4, x from
// the outer joint to the inner. Frame 4: y back along axis 4, z along axis 5.
// Frame 5: y back along axis 5, z along axis 6.
ArmModel::Bodies MakeBodies(const UrArm::Params& arm) {
  const double s = arm.base_radius / kUr5Base;
  const double upper = arm.upper_arm_side, fore = arm.forearm_side;
  const Vector3d shoulder(-arm.a2, 0, 0), elbow(-arm.a3, 0, 0);
  const Vector3d upper_arm(0, 0, upper), forearm(0, 0, fore);
  ArmModel::Bodies bodies;
  bodies.base_radius = arm.base_radius;
  bodies.base = {Cylinder(Axis::kZ, s * kUr5Base, 0, s * 0.028)};
  bodies.links = {{
      {Cylinder(Axis::kY, s * kShoulder, s * -0.060, s * 0.060),
       Cylinder(Axis::kZ, s * kShoulder, 0, upper - s * 0.064)},
      {Cylinder(Axis::kZ, s * kShoulder, upper - s * 0.062, upper + s * 0.062,
                shoulder),
       Cylinder(Axis::kX, s * kUpperArm, 0, -arm.a2, upper_arm),
       Cylinder(Axis::kZ, s * kUpperArm, upper - s * 0.066, upper + s * 0.062)},
      {Cylinder(Axis::kZ, s * kForearm, fore - s * 0.054, fore + s * 0.052,
                elbow),
       Cylinder(Axis::kX, s * kForearm, 0, -arm.a3, forearm),
       Cylinder(Axis::kZ, s * kWrist, fore - s * 0.052, fore + s * 0.044)},
      {Cylinder(Axis::kY, s * kWrist, s * -0.046, s * 0.046),
       Cylinder(Axis::kZ, s * kWrist, 0, s * 0.046)},
      {Cylinder(Axis::kY, s * kWrist, s * -0.046, s * 0.046),
       Cylinder(Axis::kZ, s * kWrist, 0, s * 0.046)},
      {Cylinder(Axis::kZ, s * kWrist, s * -0.034, 0)},
  }};
  return bodies;
}

// In [-pi, pi].
double Wrapped(double angle) {
  return std::remainder(angle, 2 * kPi);
}

}  // namespace

UrArm::UrArm(Params params)
    : params_(std::move(params)),
      rows_{{{params_.d1, 0, 1, 0},
             {0, params_.a2, 0, 1},
             {0, params_.a3, 0, 1},
             {params_.d4, 0, 1, 0},
             {params_.d5, 0, -1, 0},
             {params_.d6, 0, 0, 1}}},
      bodies_(MakeBodies(params_)) {
  const double size = (std::abs(params_.a2) + std::abs(params_.a3)) / kUr5Reach;
  // What it carries is not larger on a larger arm.
  const double flange = params_.d6 - kUr5D6;
  const double wrist = flange + params_.d5 - kUr5D5;
  const double forearm = wrist + std::abs(params_.a3) - kUr5A3;
  const double arm = wrist + (size - 1) * kUr5Reach;
  levers_ = Ur5Levers() + Joints{{arm, arm, forearm, wrist, flange, 0}};
  min_determinant_ = size * size * size * kUr5Determinant;
  min_wrist_distance_ = params_.d4 / kUr5D4 * kUr5WristDistance;
}

const Joints& UrArm::ready() const {
  // [rad] Elbow up, the wrist in front of axis 1.
  static const Joints ready = kPi / 180 * Joints{{0, -105, 75, -60, -90, 0}};
  return ready;
}

bool UrArm::MayCollide(size_t body_a, size_t body_b) const {
  const size_t inner = std::min(body_a, body_b);
  const size_t outer = std::max(body_a, body_b);
  constexpr size_t kWristBody = kFirstLinkBody + 4;  // link 5
  constexpr size_t kUpperArmBody = kFirstLinkBody + 1;
  if (outer >= kNumBodies) return inner < kWristBody;  // what it carries
  // The upper arm's housing turns right above the base.
  if (inner == kBaseBody && outer == kUpperArmBody) return false;
  // The plinth is a neighbour of what turns on it; in the wrist three bodies in
  // a row are neighbours, since its axes meet.
  if (inner == kPlinthBody) return outer > kFirstLinkBody;
  const bool is_wrist = inner >= kFirstLinkBody + 2;
  return outer - inner > (is_wrist ? 2u : 1u);
}

// Rz(angle) Tz(d) Tx(a) Rx(alpha).
Isometry3d UrArm::DhTransform(const DhRow& row, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Isometry3d X = Isometry3d::Identity();
  X.linear() << c, -s * row.cos_alpha, s * row.sin_alpha,  //
      s, c * row.cos_alpha, -c * row.sin_alpha,            //
      0, row.sin_alpha, row.cos_alpha;
  X.translation() << row.a * c, row.a * s, row.d;
  return X;
}

// How far the wrist is in front of axis 1, in the plane that the arm moves in.
double UrArm::ReachOf(const Joints& q) const {
  return -params_.a2 * std::cos(q[1]) - params_.a3 * std::cos(q[1] + q[2]) -
         params_.d5 * std::sin(q[1] + q[2] + q[3]);
}

// The planar arm of links a2 and a3 that ends at `p` in frame 1 and turns by
// `sum` = q2 + q3 + q4: none, one or two solutions.
void UrArm::SolvePlanar(const Vector3d& p, double sum, Joints q,
                        std::vector<Joints>* solutions) const {
  const double square = p.x() * p.x() + p.y() * p.y();
  const double cosine =
      (square - params_.a2 * params_.a2 - params_.a3 * params_.a3) /
      (2 * params_.a2 * params_.a3);
  if (std::abs(cosine) > 1 + kTiny) return;
  const double elbow = std::acos(std::clamp(cosine, -1.0, 1.0));
  for (const double q3 : {elbow, -elbow}) {
    q[2] = q3;
    // p = (a2 + a3 e^{i q3}) e^{i q2}, in the plane's complex numbers.
    q[1] = Wrapped(std::atan2(p.y(), p.x()) -
                   std::atan2(params_.a3 * std::sin(q3),
                              params_.a2 + params_.a3 * std::cos(q3)));
    q[3] = Wrapped(sum - q[1] - q[2]);
    solutions->push_back(q);
    if (elbow == 0) break;
  }
}

ArmModel::LinkFrames UrArm::LinkPoses(const Joints& q) const {
  LinkFrames X;
  Isometry3d X_BL = Isometry3d::Identity();
  for (size_t i = 0; i < rows_.size(); ++i) {
    X_BL = X_BL * DhTransform(rows_[i], q[static_cast<int>(i)]);
    X[i] = X_BL;
  }
  return X;
}

ArmModel::JacobianMatrix UrArm::Jacobian(const Joints& q) const {
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

std::vector<Joints> UrArm::SolveInverse(const Isometry3d& X_BF,
                                        const Joints& seed) const {
  std::vector<Joints> solutions;
  const Matrix3d& R = X_BF.linear();
  const Vector3d p = X_BF.translation();
  const Vector3d p5 = p - params_.d6 * R.col(2);  // origin of frame 5
  // Seen from above p5 lies d4 beside the plane of axes 2, 3 and 4:
  // p5.x sin q1 - p5.y cos q1 = d4.
  const double rho = std::hypot(p5.x(), p5.y());
  if (rho < params_.d4 - kTiny || rho == 0) return solutions;
  const double azimuth = std::atan2(p5.y(), p5.x());
  const double side = std::asin(std::min(params_.d4 / rho, 1.0));
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
                 ? seed[5]
                 : std::atan2(-R.col(1).dot(z1) / s5, R.col(0).dot(z1) / s5);
      const Isometry3d X_46 =
          DhTransform(rows_[4], q5) * DhTransform(rows_[5], q[5]);
      const Isometry3d X_14 =
          DhTransform(rows_[0], q1).inverse() * X_BF * X_46.inverse();
      // x4 in frame 1 is (cos, sin, 0) of q2 + q3 + q4; origin 4 lies d4 along
      // z1 from origin 3.
      const double sum = std::atan2(X_14(1, 0), X_14(0, 0));
      SolvePlanar(X_14.translation(), sum, q, &solutions);
      if (is_free) break;
    }
    if (rho <= params_.d4) break;
  }
  return solutions;
}

IkConfiguration UrArm::ConfigurationOf(const Joints& q) const {
  const int index = (ReachOf(q) < 0 ? 1 : 0) | (std::sin(q[2]) < 0 ? 2 : 0) |
                    (std::sin(q[4]) < 0 ? 4 : 0);
  return {static_cast<uint8_t>(index)};
}

UrArm::Manipulability UrArm::ManipulabilityOf(const Joints& q) const {
  Manipulability m;
  m.elbow = std::sin(q[2]);
  m.wrist = std::sin(q[4]);
  m.reach = ReachOf(q);
  m.determinant =
      std::abs(params_.a2 * params_.a3 * m.elbow * m.wrist * m.reach);
  m.wrist_distance = std::hypot(params_.d4, m.reach);
  return m;
}

bool UrArm::IsNearSingularity(const Joints& q) const {
  const Manipulability m = ManipulabilityOf(q);
  return std::abs(m.elbow) <= kMinSine || std::abs(m.wrist) <= kMinSine ||
         m.determinant <= min_determinant_ ||
         m.wrist_distance <= min_wrist_distance_;
}

}  // namespace cell
