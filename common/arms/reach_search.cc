#include "common/arms/reach_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kAligned = 0.999;     // cosine of axes that count as one
constexpr int kLast = kNumJoints - 1;  // turns about z of the flange

Isometry3d TurnedAboutZ(double angle) {
  return Isometry3d(AngleAxisd(angle, Vector3d::UnitZ()));
}

// A long way from the seed is bad, and so is a joint near its limit.
double CostOf(const ArmModel& arm, const Joints& q, const Joints& seed) {
  constexpr double kLimitWeight = 0.2;  // [rad^2]
  return (q - seed).norm() + kLimitWeight / std::max(arm.LimitMargin(q), 0.01);
}

// "outside the arm's workspace: x at -380 mm, -355 to 555 mm are allowed"
std::string WhyOutside(const Eigen::AlignedBox3d& workspace,
                       const std::vector<Isometry3d>& poses) {
  for (const Isometry3d& X_WG : poses) {
    for (int i = 0; i < 3; ++i) {
      const double p = X_WG.translation()[i];
      if (p >= workspace.min()[i] && p <= workspace.max()[i]) continue;
      return fmt::format(
          "outside the arm's workspace: {} of the gripper at {:.1f} mm, {:.0f} "
          "to {:.0f} mm are allowed",
          "xyz"[i], 1e3 * p, 1e3 * workspace.min()[i],
          1e3 * workspace.max()[i]);
    }
  }
  return "outside the arm's workspace";
}

// "beyond a joint limit: joint 6 at 480.2 deg, 358.9 deg are allowed"
std::string WhyBeyond(const ArmModel& arm, const Joints& q, double turn,
                      double margin) {
  int worst = 0;
  const double turned = q[kLast] + turn;
  Joints farthest = q;
  if (std::abs(turned) > std::abs(q[kLast])) farthest[kLast] = turned;
  (farthest.cwiseAbs() - arm.limits().angle).maxCoeff(&worst);
  constexpr double kDegrees = 180 / kPi;
  return fmt::format(
      "beyond a joint limit: joint {} at {:.1f} deg, {:.1f} deg either way are "
      "allowed",
      worst + 1, kDegrees * farthest[worst],
      kDegrees * (arm.limits().angle[worst] - margin));
}

template <class Candidates>
void SortByCost(Candidates* candidates) {
  std::ranges::stable_sort(*candidates, {}, [](const auto& candidate) {
    return candidate.choice.cost;
  });
}

}  // namespace

void ReachSearch::Fail(Stage stage, const std::string& reason) {
  if (!reason_.empty() && stage <= stage_) return;
  stage_ = stage;
  reason_ = reason;
}

// True if the last joint, at a whole turn from where it is, can turn by `turn`.
bool ReachSearch::FindRoom(Joints* q, double turn) const {
  const double limit =
      arm_.model->limits().angle[kLast] - params_.line.joint_margin;
  // Of its copies the first that is near enough to its place.
  for (const double whole : {0.0, 2 * kPi, -2 * kPi}) {
    const double begin = (*q)[kLast] + whole;
    if (std::abs(begin) > limit || std::abs(begin + turn) > limit) continue;
    (*q)[kLast] = begin;
    return arm_.model->LimitMargin(*q) >= params_.line.joint_margin;
  }
  return false;
}

// Every straight way of the gripper from begin to end, each from its end back.
std::vector<std::vector<Joints>> ReachSearch::Tracks(
    const Isometry3d& X_WG_begin, const Isometry3d& X_WG_end,
    const Joints& seed, double turn) {
  std::vector<std::vector<Joints>> tracks;
  const Eigen::AlignedBox3d workspace = arm_.PlannedWorkspace();
  if (!workspace.contains(X_WG_begin.translation()) ||
      !workspace.contains(X_WG_end.translation())) {
    Fail(Stage::kReach, WhyOutside(workspace, {X_WG_begin, X_WG_end}));
    return tracks;
  }
  const auto solutions =
      arm_.model->SolveInverse(FlangePoseFor(arm_, X_WG_end), seed);
  if (solutions.empty()) Fail(Stage::kReach, "out of reach");
  for (const Joints& solution : solutions) {
    Joints q = arm_.model->NearestTo(seed, solution);
    if (!FindRoom(&q, turn)) {
      Fail(Stage::kLimits,
           WhyBeyond(*arm_.model, q, turn, params_.line.joint_margin));
      continue;
    }
    StraightLine line = TrackLine(arm_, q, X_WG_begin, params_.line);
    if (!line) {
      Fail(Stage::kRegular, line.reason());
      continue;
    }
    tracks.push_back(*std::move(line));
  }
  return tracks;
}

bool ReachSearch::IsFree(const ArmScene& scene,
                         const std::vector<Joints>& track,
                         const std::string& grip, double opening,
                         const ClearanceRule& rule) {
  for (const Joints& q : track) {
    if (const auto why =
            scene.WhyBlocked(arm_.name, {q, grip, opening}, rule)) {
      Fail(Stage::kCollision, *why);
      return false;
    }
  }
  return true;
}

bool ReachSearch::Suits(const GraspChoice& choice) {
  const HandType& hand = arm_.hand;
  if (hand.FindGrip(choice.grip) == nullptr) {
    Fail(Stage::kGrip, "the hand does not have this grip");
    return false;
  }
  if (choice.opening > hand.max_opening) {
    Fail(Stage::kHand, "too wide for the hand");
    return false;
  }
  return true;
}

std::vector<ReachSearch::Candidate<GraspChoice>> ReachSearch::ToGrasp(
    const Part& part, const Isometry3d& X_WO, const Joints& seed) {
  std::vector<Candidate<GraspChoice>> candidates;
  const auto add = [&](GraspChoice choice, double preference) {
    const Isometry3d X_WG = X_WO * choice.X_OG;
    const Isometry3d X_WG_begin =
        X_WG * Eigen::Translation3d(0, 0, params_.approach);
    for (auto& track : Tracks(X_WG_begin, X_WG, seed, 0)) {
      choice.q_grasp = track.front();
      choice.q_approach = track.back();
      choice.cost = CostOf(*arm_.model, choice.q_approach, seed) + preference;
      candidates.push_back({choice, std::move(track)});
    }
  };
  for (size_t i = 0; i < part.grasps.size(); ++i) {
    const Grasp& grasp = part.grasps[i];
    for (size_t rank = 0; rank < grasp.grips.size(); ++rank) {
      GraspChoice choice{i, grasp.grips[rank],
                         grasp.width + params_.open_margin, grasp.width};
      if (!Suits(choice)) continue;
      for (const double turn : {0.0, kPi}) {
        choice.X_OG = grasp.X_OG * TurnedAboutZ(turn);
        add(choice, static_cast<double>(rank));
      }
    }
  }
  SortByCost(&candidates);
  return candidates;
}

std::vector<ReachSearch::Candidate<PlaceChoice>> ReachSearch::ToPlace(
    const Part& part, const Isometry3d& X_GO, const PlaceTarget& target,
    const Joints& seed) {
  const int num_copies =
      part.symmetry_order == 0 ? params_.free_turns : part.symmetry_order;
  std::vector<Candidate<PlaceChoice>> candidates;
  for (int i = 0; i < num_copies; ++i) {
    PlaceChoice choice;
    choice.X_WO = target.X_WO * TurnedAboutZ(2 * kPi * i / num_copies);
    const Isometry3d X_WG = choice.X_WO * X_GO.inverse();
    // The last joint turns against z of G.
    const double along = -X_WG.linear().col(2).dot(target.way_out);
    if (target.turn != 0 && std::abs(along) < kAligned) {
      Fail(Stage::kHand, "the grip is off the axis of rotation");
      continue;
    }
    const Isometry3d X_WG_begin =
        Eigen::Translation3d(target.approach * target.way_out) * X_WG;
    const double turn = std::copysign(1.0, along) * target.turn;
    for (auto& track : Tracks(X_WG_begin, X_WG, seed, turn)) {
      choice.q_place = track.front();
      choice.q_turned = choice.q_place + turn * Joints::Unit(kLast);
      choice.q_approach = track.back();
      choice.cost = CostOf(*arm_.model, choice.q_approach, seed);
      candidates.push_back({choice, std::move(track)});
    }
  }
  SortByCost(&candidates);
  return candidates;
}

}  // namespace cell
