#include "services/vtb/hand_actor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cell::vtb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kTableApproach = 0.03;  // [m] straight down onto the table
constexpr double kRetreat = 0.10;        // [m] straight back after letting go
constexpr double kRaise = 0.03;          // [m] before another try
constexpr double kRaiseTime = 1.0;       // [s]
constexpr double kRelaxTime = 0.2;       // [s] until no force is left
constexpr double kThreadPush = 0.0015;   // [m] onto a thread, before turning
constexpr double kRestOpening = 0.03;    // [m] between the fingers
constexpr int kMaxTries = 4;

// The search of a person who feels that it does not go in.
constexpr double kSearchAfter = 0.4;    // [s]
constexpr double kSearchTime = 5;       // [s] before it raises the part
constexpr double kSearchTurns = 1.2;    // [1/s]
constexpr double kSearchSpread = 8e-4;  // [m/s]
constexpr double kSearchRadius = 3e-3;  // [m] at most
constexpr double kSearchTwist = 0.02;   // [rad]
constexpr double kTurnTime = 20;        // [s] at most
constexpr double kStill = 0.005;        // [m/s]

/// How far below G's origin an empty hand reaches, and a tilted one.
constexpr double kTipDrop = 0.005, kTiltedDrop = 0.06;
constexpr double kSideClearance = 0.08;  // [m] beside a way across

Isometry3d Shifted(Isometry3d X, const Vector3d& by_W) {
  X.translation() += by_W;
  return X;
}

double DistanceToSegment(const Vector2d& p, const Vector2d& a,
                         const Vector2d& b) {
  const Vector2d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s =
      length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0;
  return (p - a - s * ab).norm();
}

double AngleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return AngleAxisd(a.transpose() * b).angle();
}

double TiltOf(const Eigen::Matrix3d& R) {
  return std::acos(std::clamp(R(2, 2), -1.0, 1.0));
}

Isometry3d PoseOfSite(const std::string& name, const World& world) {
  const Site& site = *world.table().FindSite(name);
  return world.PoseOf(site.host) * site.X_HS;
}

const Thread* ThreadOf(const std::string& site, const World& world) {
  return world.table().FindThread(world.table().FindSite(site)->type);
}

/// The rotation about z, among those that leave the part as it is, that brings
/// it from R_WO to the target with the least turning.
Eigen::Matrix3d BestSymmetry(int order, const Eigen::Matrix3d& R_WO,
                             const Eigen::Matrix3d& R_WS) {
  constexpr int kAnyAngle = 24;
  const int count = order == 0 ? kAnyAngle : order;
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  double best_angle = 10;
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix3d R =
        AngleAxisd(2 * kPi * i / count, Vector3d::UnitZ()).toRotationMatrix();
    const double angle = AngleBetween(R_WO, R_WS * R);
    if (angle < best_angle) {
      best_angle = angle;
      best = R;
    }
  }
  return best;
}

}  // namespace

HandActor::HandActor(std::string hand, const Manner& manner, const World& world)
    : hand_(std::move(hand)),
      manner_(manner),
      X_WG_(Isometry3d::Identity()),
      X_WG_rest_(Isometry3d::Identity()) {
  for (const CellLayout::Hand& layout : world.layout().hands) {
    if (layout.name == hand_) X_WG_rest_.translation() = layout.p_WG_rest;
  }
  X_WG_ = X_WG_rest_;
}

void HandActor::Take(const std::string& part, const std::string& from_site) {
  steps_.push_back({Step::kReach, part, from_site, {}});
  steps_.push_back({Step::kClose, part, from_site, {}});
  steps_.push_back({Step::kPause, part, "", {}, manner_.dwell});
  if (!from_site.empty()) {
    steps_.push_back({Step::kExtract, part, from_site, {}});
  }
}

void HandActor::Put(const std::string& part, const Target& target) {
  for (const Step step :
       {Step::kCarry, Step::kLower, Step::kSettle, Step::kTurn, Step::kRelax,
        Step::kOpen, Step::kRetreat}) {
    steps_.push_back({step, part, "", target});
  }
}

void HandActor::GoToRest() {
  steps_.push_back({Step::kRest, "", "", {}});
}

void HandActor::Pause(double duration) {
  steps_.push_back({Step::kPause, "", "", {}, duration});
}

std::vector<Vector2d> HandActor::WayAhead(const World& world) const {
  std::vector<Vector2d> way{X_WG_.translation().head<2>()};
  for (const Order& order : steps_) {
    if (order.step == Step::kReach) {
      way.push_back(world.PoseOf(order.part).translation().head<2>());
    } else if (order.step == Step::kCarry) {
      const Isometry3d X_WO = order.target.rule != nullptr
                                  ? PoseOfSite(order.target.site, world)
                                  : order.target.X_WO;
      way.push_back(X_WO.translation().head<2>());
    } else if (order.step == Step::kRest) {
      way.push_back(X_WG_rest_.translation().head<2>());
    }
  }
  return way;
}

double HandActor::Spread(std::mt19937_64& random) const {
  return std::uniform_real_distribution<double>(
      1 - manner_.speed_spread, 1 + manner_.speed_spread)(random);
}

Isometry3d HandActor::GoalOf(const Order& order, const World& world) const {
  if (order.target.rule == nullptr) return X_WO_table_;
  return PoseOfSite(order.target.site, world) *
         Translation3d(order.target.rule->aim + aim_error_) *
         Isometry3d(Eigen::Quaterniond(symmetry_));
}

Vector3d HandActor::WayOut(const std::string& site, const World& world) const {
  if (site.empty()) return Vector3d::UnitZ();
  return PoseOfSite(site, world).linear().col(2);
}

bool HandActor::IsSeated(const Order& order, const World& world) const {
  if (world.SpeedOf(order.part) > kStill) return false;
  const PlacementRule* rule = order.target.rule;
  if (rule == nullptr) return true;
  if (ThreadOf(order.target.site, world) != nullptr) {
    return world.IsOnThread(order.target.site, order.part);
  }
  const Isometry3d X_SO =
      PoseOfSite(order.target.site, world).inverse() * world.PoseOf(order.part);
  return std::abs(X_SO.translation().z()) < rule->seated.z &&
         X_SO.translation().head<2>().norm() < rule->seated.xy &&
         TiltOf(X_SO.linear()) < rule->seated.tilt;
}

void HandActor::Update(double dt, World& world, const Tabletop& tabletop,
                       std::mt19937_64& random) {
  dt_ = dt;
  if (!steps_.empty()) {
    if (!has_begun_) {
      time_ = 0;
      opening_from_ = opening_to_ = opening_;
      path_ = HandPath(X_WG_);
      Begin(world, tabletop, random);
      has_begun_ = true;
    }
    time_ += dt;
    const Order order = steps_.front();
    if (Act(world)) {
      // Act may have put further steps in front of it.
      has_begun_ = false;
      const auto done = std::ranges::find_if(steps_, [&](const Order& o) {
        return o.step == order.step && o.part == order.part;
      });
      steps_.erase(done);
    }
  }
  world.hands().Move(hand_, X_WG_, opening_);
}

void HandActor::Begin(World& world, const Tabletop& tabletop,
                      std::mt19937_64& random) {
  const Order& order = steps_.front();
  const auto follow = [&](const Isometry3d& X_WG, double duration) {
    path_ = HandPath::Straight(X_WG_, X_WG, duration);
  };
  switch (order.step) {
    case Step::kPause:
    case Step::kSettle:
    case Step::kTurn:
      break;
    case Step::kReach:
      PlanReach(order, world, tabletop, random);
      break;
    case Step::kClose:
      opening_to_ = grasp_width_;
      break;
    case Step::kExtract: {
      const double way = world.table().FindSite(order.site)->approach;
      follow(Shifted(X_WG_, way * WayOut(order.site, world)),
             way / (manner_.insert_speed * Spread(random)));
      break;
    }
    case Step::kCarry:
      PlanCarry(order, world, tabletop, random);
      break;
    case Step::kLower: {
      double beyond = order.target.rule ? order.target.rule->press : 0.001;
      if (order.target.rule != nullptr) {
        if (const Thread* thread = ThreadOf(order.target.site, world)) {
          beyond = kThreadPush - thread->engagement;
        }
      }
      const Isometry3d X_WG =
          Shifted(GoalOf(order, world), -beyond * way_out_) * X_GO_.inverse();
      const double way = (X_WG.translation() - X_WG_.translation()).norm();
      follow(X_WG, way / (manner_.insert_speed * Spread(random)));
      break;
    }
    case Step::kRaise:
      follow(Shifted(X_WG_, kRaise * way_out_), kRaiseTime);
      break;
    case Step::kRelax: {
      const Isometry3d X_GO =
          Isometry3d(AngleAxisd(roll_, Vector3d::UnitZ())) * X_GO_;
      follow(world.PoseOf(order.part) * X_GO.inverse(), kRelaxTime);
      break;
    }
    case Step::kOpen:
      world.hands().Release(hand_);
      roll_ = 0;
      opening_to_ = grasp_width_ + 2 * manner_.open_margin;
      break;
    case Step::kRetreat:
      follow(Shifted(X_WG_, kRetreat * X_WG_.linear().col(2)),
             kRetreat / (2 * manner_.insert_speed * Spread(random)));
      break;
    case Step::kRest:
      path_ = WayOver(X_WG_rest_, world, tabletop, random);
      if (!world.hands().HeldBy(hand_)) opening_to_ = kRestOpening;
      break;
  }
}

bool HandActor::Act(World& world) {
  const Order order = steps_.front();
  double duration = path_.duration();
  switch (order.step) {
    case Step::kSettle:
      return Settle(order, world);
    case Step::kTurn:
      return Turn(order, world);
    case Step::kPause:
      return time_ >= order.duration;
    case Step::kRelax:
      duration += manner_.dwell;
      break;
    case Step::kClose:
    case Step::kOpen:
      duration = manner_.close_time;
      break;
    default:
      break;
  }
  X_WG_ = path_.At(time_);
  opening_ = opening_from_ +
             (opening_to_ - opening_from_) * MinimumJerk(time_ / duration);
  if (time_ < duration) return false;
  if (order.step == Step::kClose) {
    if (world.hands().IsHeld(order.part)) {  // somebody else was quicker
      steps_.clear();
      steps_.push_back(order);
      steps_.push_back({Step::kRetreat, order.part, "", {}});
      GoToRest();
      return true;
    }
    world.hands().Grip(hand_, order.part);
    X_GO_ = X_WG_.inverse() * world.PoseOf(order.part);
    tries_ = 0;
  }
  return true;
}

void HandActor::PlanReach(const Order& order, World& world,
                          const Tabletop& tabletop, std::mt19937_64& random) {
  const Part& part = *world.table().Find(order.part);
  const auto& grasps = part.grasps;
  const Grasp& grasp = grasps[std::uniform_int_distribution<size_t>(
      0, grasps.size() - 1)(random)];
  // Thumb and fingers may change sides.
  Isometry3d X_WG = world.PoseOf(order.part) * grasp.X_OG;
  const Isometry3d flipped =
      X_WG * Isometry3d(AngleAxisd(kPi, Vector3d::UnitZ()));
  if (AngleBetween(X_WG_.linear(), flipped.linear()) <
      AngleBetween(X_WG_.linear(), X_WG.linear())) {
    X_WG = flipped;
  }
  grasp_width_ = grasp.width;
  opening_to_ = grasp.width + 2 * manner_.open_margin;
  path_ = WayOver(X_WG, world, tabletop, random);
}

void HandActor::PlanCarry(const Order& order, World& world,
                          const Tabletop& tabletop, std::mt19937_64& random) {
  symmetry_ = Eigen::Matrix3d::Identity();
  aim_error_ = Vector3d::Zero();
  way_out_ = Vector3d::UnitZ();
  double approach = kTableApproach;
  if (order.target.rule != nullptr) {
    const Site& site = *world.table().FindSite(order.target.site);
    const Isometry3d X_WS = PoseOfSite(site.name, world);
    symmetry_ = BestSymmetry(world.table().Find(order.part)->symmetry_order,
                             world.PoseOf(order.part).linear(), X_WS.linear());
    std::uniform_real_distribution<double> error(-manner_.aim_error,
                                                 manner_.aim_error);
    aim_error_.x() = error(random);
    aim_error_.y() = error(random);
    way_out_ = X_WS.linear().col(2);
    approach = site.approach;
  } else {
    X_WO_table_ = order.target.X_WO;
    if (order.target.tilt != 0) {
      const Vector3d between_fingers = X_GO_.linear().row(0).transpose();
      X_WO_table_.linear() *=
          AngleAxisd(order.target.tilt, between_fingers).toRotationMatrix();
      X_WO_table_.translation().z() -=
          tabletop.ExtentOf(order.part).Lowest(X_WO_table_);
    }
  }
  const Isometry3d X_WG =
      Shifted(GoalOf(order, world), approach * way_out_) * X_GO_.inverse();
  path_ = WayOver(X_WG, world, tabletop, random);
}

HandPath HandActor::WayOver(const Isometry3d& X_WG, const World& world,
                            const Tabletop& tabletop, std::mt19937_64& random) {
  const Vector2d from = X_WG_.translation().head<2>();
  const Vector2d to = X_WG.translation().head<2>();
  const bool is_tilting =
      AngleBetween(X_WG_.linear(), X_WG.linear()) > 1e-6 &&
      (TiltOf(X_WG_.linear()) > 0.1 || TiltOf(X_WG.linear()) > 0.1);
  double radius = kSideClearance;
  double drop = is_tilting ? kTiltedDrop : kTipDrop;
  const std::optional<std::string> held = world.hands().HeldBy(hand_);
  if (held) {
    const PartExtent& extent = tabletop.ExtentOf(*held);
    radius += X_GO_.translation().head<2>().norm() + extent.radius;
    const auto hang = [&](const Isometry3d& X) {
      return X.translation().z() - extent.Lowest(X * X_GO_);
    };
    drop = std::max({drop, hang(X_WG_), hang(X_WG)});
    if (is_tilting) {
      drop = std::max(drop, X_GO_.translation().norm() + extent.radius);
    }
  }
  double top = 0;
  for (const Part& other : world.table().parts()) {
    if (held == other.name) continue;
    const Isometry3d X_WO = world.PoseOf(other.name);
    const PartExtent& extent = tabletop.ExtentOf(other.name);
    if (DistanceToSegment(X_WO.translation().head<2>(), from, to) <
        radius + extent.RadiusAcross(X_WO)) {
      top = std::max(top, extent.Highest(X_WO));
    }
  }
  std::uniform_real_distribution<double> unit(0, 1);
  const double clear_z = top + manner_.clearance / 2 + drop;
  const double top_z = clear_z + manner_.clearance * (0.5 + unit(random));
  HandPath::Speeds speeds = manner_.speeds;
  speeds.across *= Spread(random);
  speeds.along *= Spread(random);
  const double bend = manner_.bend * (2 * unit(random) - 1);
  return HandPath::Over(X_WG_, X_WG, clear_z, top_z, bend, speeds);
}

bool HandActor::Settle(const Order& order, World& world) {
  constexpr double kFirstLook = 0.1;
  if (time_ >= kFirstLook && IsSeated(order, world)) return true;
  if (time_ < kSearchAfter) return false;
  if (time_ > kSearchTime) {
    if (++tries_ >= kMaxTries) {
      failures_.push_back(order.part);
      return true;
    }
    TryAgain(order);
    return true;
  }
  // Ever wider circles about the way in, with a little twist.
  const double t = time_ - kSearchAfter;
  const double radius = std::min(kSearchSpread * t, kSearchRadius);
  const double angle = 2 * kPi * kSearchTurns * t;
  const Eigen::Quaterniond R =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), way_out_);
  X_WG_ = Shifted(path_.At(0), R * Vector3d(radius * std::cos(angle),
                                            radius * std::sin(angle), 0));
  X_WG_.linear() = AngleAxisd(kSearchTwist * std::sin(0.7 * angle), way_out_) *
                   X_WG_.linear();
  return false;
}

void HandActor::TryAgain(const Order& order) {
  // The settling that ends now stands first; the caller erases it.
  auto at = steps_.begin() + 1;
  for (const Step step : {Step::kSettle, Step::kLower, Step::kRaise}) {
    Order again = order;
    again.step = step;
    at = steps_.insert(at, again);
  }
}

bool HandActor::Turn(const Order& order, World& world) {
  if (order.target.rule == nullptr ||
      ThreadOf(order.target.site, world) == nullptr ||
      world.IsTurnedHome(order.target.site, order.part)) {
    return true;
  }
  if (time_ > kTurnTime) {
    failures_.push_back(order.part);
    return true;
  }
  roll_ -= manner_.turn_rate * dt_;
  world.hands().Roll(hand_, roll_);
  // The hand goes with the part along its axis.
  const Isometry3d X_WS = PoseOfSite(order.target.site, world);
  const double z =
      (X_WS.inverse() * world.PoseOf(order.part).translation()).z();
  X_WG_.translation() =
      X_WS * Vector3d(0, 0, z) - X_WG_.linear() * X_GO_.translation();
  return false;
}

}  // namespace cell::vtb
