#include "common/arms/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/arms/ur5.h"

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr int kAnyAngle = 24;       // turns tried of a part that has no front
constexpr double kLineStep = 0.02;  // [m]
constexpr double kMaxStep = 0.5;    // [rad] of a joint within it
constexpr double kLimitMargin = 0.05;  // [rad]
constexpr size_t kMaxPicks = 16;       // tried for a placement

Isometry3d AboutZ(double angle) {
  return Isometry3d(AngleAxisd(angle, Vector3d::UnitZ()));
}

int NumTurns(int symmetry_order) {
  return symmetry_order == 0 ? kAnyAngle : symmetry_order;
}

double Way(const Joints& a, const Joints& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Keeps the first reason of those that came nearest to success.
class Excuse {
 public:
  void Note(int stage, const std::string& reason) {
    if (stage <= stage_) return;
    stage_ = stage;
    reason_ = reason;
  }
  const std::string& reason() const { return reason_; }

 private:
  int stage_ = 0;
  std::string reason_ = "it is out of reach";
};

}  // namespace

std::vector<Joints> Reach::Solutions(const Isometry3d& X_WG,
                                     const Joints& seed) const {
  const ArmLayout& arm = scene_.arm();
  const Isometry3d X_BF = arm.X_WB.inverse() * X_WG * arm.X_FG.inverse();
  std::vector<Joints> solutions;
  for (const Joints& q : ur5::Inverse(X_BF)) {
    if (ur5::Dexterity(q) < params_.dexterity) continue;
    solutions.push_back(ur5::Nearest(q, seed));
  }
  return solutions;
}

/// The joints at the end of a straight way that begins with `q`.
std::optional<Joints> Reach::FollowLine(const Joints& q,
                                        const Isometry3d& X_WG_from,
                                        const Isometry3d& X_WG_to) const {
  const ArmLayout& arm = scene_.arm();
  const Vector3d way = X_WG_to.translation() - X_WG_from.translation();
  const int num =
      std::max(1, static_cast<int>(std::ceil(way.norm() / kLineStep)));
  Joints last = q;
  for (int i = 1; i <= num; ++i) {
    Isometry3d X_WG = X_WG_from;
    X_WG.translation() += way * i / num;
    const auto next = ur5::InverseNear(
        arm.X_WB.inverse() * X_WG * arm.X_FG.inverse(), last, kMaxStep);
    if (!next || ur5::Dexterity(*next) < params_.dexterity) return std::nullopt;
    last = *next;
  }
  return last;
}

Reach::OrReason<std::vector<Pick>> Reach::Picks(const std::string& name,
                                                const Joints& seed,
                                                bool only_fixed) const {
  const Part* part = parts_.Find(name);
  const auto pose = scene_.poses().find(name);
  if (part == nullptr || pose == scene_.poses().end()) {
    return "nobody knows where " + name + " is";
  }
  const ArmLayout& arm = scene_.arm();
  std::vector<Pick> picks;
  Excuse excuse;
  for (const Grasp& grasp : part->grasps) {
    const auto grip = std::ranges::find_if(grasp.grips, [&](const auto& g) {
      return arm.hand.FindGrip(g) != nullptr;
    });
    if (grip == grasp.grips.end() ||
        grasp.width + 2 * params_.near_clearance > arm.hand.max_opening) {
      excuse.Note(1, "its hand cannot grip " + name);
      continue;
    }
    const int num_turns = part->symmetry_order == 0 ? 8 : 1;
    for (int i = 0; i < 2 * num_turns; ++i) {
      Pick pick{AboutZ(std::numbers::pi * i / num_turns) * grasp.X_OG, *grip,
                grasp.width};
      if (num_turns == 1) {
        pick.X_OG = grasp.X_OG * AboutZ(std::numbers::pi * i);
      }
      pick.opening =
          std::min(grasp.width + 2 * params_.open_margin, arm.hand.max_opening);
      const Isometry3d X_WG = pose->second * pick.X_OG;
      if (!arm.workspace.contains(X_WG.translation())) {
        excuse.Note(2, name + " is outside its workspace");
        continue;
      }
      const Isometry3d X_WA = X_WG * Translation3d(0, 0, params_.approach);
      for (const Joints& q : Solutions(X_WA, seed)) {
        ArmScene::Question question{.clearance = params_.clearance,
                                    .grasped = name,
                                    .only_fixed = only_fixed};
        if (auto hit = scene_.WhyNot({q, *grip, pick.opening}, question)) {
          excuse.Note(3, *hit);
          continue;
        }
        const auto at_grasp = FollowLine(q, X_WA, X_WG);
        if (!at_grasp) {
          excuse.Note(4, "the straight way to it leads out of reach");
          continue;
        }
        question.clearance = params_.near_clearance;
        if (auto hit =
                scene_.WhyNot({*at_grasp, *grip, pick.opening}, question)) {
          excuse.Note(5, *hit);
          continue;
        }
        pick.q_approach = q;
        pick.q_grasp = *at_grasp;
        picks.push_back(pick);
      }
    }
  }
  if (picks.empty()) return excuse.reason();
  std::ranges::stable_sort(
      picks, {}, [&](const Pick& pick) { return Way(pick.q_approach, seed); });
  return picks;
}

Reach::OrReason<std::vector<Place>> Reach::Places(const ArmScene::Held& held,
                                                  const std::string& grip,
                                                  double width,
                                                  const PlaceGoal& goal,
                                                  const Joints& seed) const {
  std::vector<Place> places;
  Excuse excuse;
  const int num_turns = NumTurns(goal.symmetry_order);
  for (int i = 0; i < num_turns; ++i) {
    Place place;
    place.X_turn = AboutZ(2 * std::numbers::pi * i / num_turns);
    const Isometry3d X_WG = goal.X_WO * place.X_turn * held.X_GO.inverse();
    Isometry3d X_WA = X_WG;
    X_WA.translation() += goal.approach * goal.way_out;
    for (const Joints& solution : Solutions(X_WA, seed)) {
      // Which way the last joint turns the part, and how far it can.
      const double along = -X_WG.linear().col(2).dot(goal.X_WO.linear().col(2));
      const double turn = -goal.turn * along;
      Joints q = solution;
      const double limit = ur5::kJointLimit - kLimitMargin;
      if (goal.turn != 0) {
        const double high = std::min(limit, limit - turn);
        const double low = std::max(-limit, -limit - turn);
        while (q[5] > high) q[5] -= 2 * std::numbers::pi;
        while (q[5] < low) q[5] += 2 * std::numbers::pi;
        if (q[5] > high) {
          excuse.Note(1, "its wrist cannot turn the part so far");
          continue;
        }
      }
      ArmScene::Question question{.clearance = params_.clearance, .held = held};
      if (auto hit = scene_.WhyNot({q, grip, width}, question)) {
        excuse.Note(2, *hit);
        continue;
      }
      const auto at_place = FollowLine(q, X_WA, X_WG);
      if (!at_place) {
        excuse.Note(3, "the straight way to the place leads out of reach");
        continue;
      }
      question.clearance =
          goal.is_site ? params_.near_clearance : params_.apart;
      question.over_table = params_.near_clearance;
      question.is_seated = goal.is_site;
      if (auto hit = scene_.WhyNot({*at_place, grip, width}, question)) {
        excuse.Note(4, *hit);
        continue;
      }
      place.q_approach = q;
      place.q_place = *at_place;
      places.push_back(place);
    }
  }
  if (places.empty()) return "its place: " + excuse.reason();
  std::ranges::stable_sort(places, {}, [&](const Place& place) {
    return Way(place.q_approach, seed);
  });
  return places;
}

Reach::OrReason<Pick> Reach::PickToPlace(const std::string& part,
                                         const PlaceGoal& goal,
                                         const Joints& seed) const {
  auto found = Picks(part, seed);
  if (auto* reason = std::get_if<std::string>(&found)) return *reason;
  std::string reason;
  size_t num_tried = 0;
  for (const Pick& pick : std::get<std::vector<Pick>>(found)) {
    if (++num_tried > kMaxPicks) break;
    auto places = Places({part, pick.X_OG.inverse()}, pick.grip, pick.width,
                         goal, pick.q_approach);
    if (std::holds_alternative<std::vector<Place>>(places)) return pick;
    if (reason.empty()) reason = std::get<std::string>(places);
  }
  return reason;
}

}  // namespace cell
