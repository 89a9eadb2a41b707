#include "services/motion_planner/request_search.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/part_shape.h"
#include "services/motion_planner/way_planner.h"

namespace cell::motion_planner {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Choices that are looked at: the best few first, then all.
constexpr size_t kBestFew = 8, kBestTransfers = 4, kAll = 1000;
constexpr double kNear = 0.0015;       // [m] at a grasp or a place
constexpr double kGrid = 0.03;         // [m] of the free places that are tried
constexpr int kYaws = 12;              // turns that are tried there
constexpr double kOverTable = 0.0005;  // [m] a part is set down from
// [m] Around a part that is set down, if there is room: its neighbours want to
// be taken, too.
constexpr double kApart[] = {0.06, 0.03, 0.012};

// Of choices that bring the gripper to about the same place in the same
// configuration one is enough: the others have the same way, or none.
class TriedApproaches {
 public:
  explicit TriedApproaches(const ArmLayout& arm) : arm_(arm) {}

  // True if nothing like it was tried; it counts as tried from now on.
  bool Add(const Joints& q) {
    const Approach approach{arm_.model->ConfigurationOf(q),
                            GripperPose(arm_, q).translation()};
    const bool is_known =
        std::ranges::any_of(approaches_, [&](const Approach& other) {
          return other.configuration == approach.configuration &&
                 (other.p_WG - approach.p_WG).norm() < kSamePlace;
        });
    if (!is_known) approaches_.push_back(approach);
    return !is_known;
  }

 private:
  static constexpr double kSamePlace = 0.03;  // [m]
  struct Approach {
    IkConfiguration configuration;
    Vector3d p_WG;
  };
  const ArmLayout& arm_;
  std::vector<Approach> approaches_;
};

ReachParams ReachParamsOf(const MotionSearch::Params& params) {
  ReachParams reach;
  reach.approach = params.motion.approach;
  reach.open_margin = 2 * params.fingers.open_margin;
  reach.clearance = kNear;
  return reach;
}

bool IsSame(const ArmPosture& a, const ArmPosture& b) {
  return a.q == b.q && a.grip == b.grip && a.opening == b.opening;
}

// The best of choices(most) to which plan(choice) has a way; else why there is
// none.
template <class Choose, class Plan>
MotionPlan BestWithWay(const ArmLayout& arm, const Choose& choices,
                       const Plan& plan) {
  MotionPlan none;
  TriedApproaches tried(arm);
  for (const size_t most : {kBestFew, kAll}) {
    const auto found = choices(most);
    if (!found) {
      if (none.reason.empty()) none.reason = found.reason();
      continue;
    }
    for (const auto& choice : *found) {
      if (!tried.Add(choice.q_approach)) continue;
      MotionPlan planned = plan(choice);
      if (planned) return planned;
      if (none.reason.empty()) none.reason = planned.reason;
    }
  }
  return none;
}

// The grid of the area, those next to its middle first.
std::vector<Vector2d> PointsIn(const Eigen::AlignedBox2d& area) {
  std::vector<Vector2d> points;
  for (double y = area.min().y(); y <= area.max().y(); y += kGrid) {
    for (double x = area.min().x(); x <= area.max().x(); x += kGrid) {
      points.emplace_back(x, y);
    }
  }
  std::ranges::stable_sort(points, {}, [&](const Vector2d& p) {
    return (p - area.center()).norm();
  });
  return points;
}

}  // namespace

RequestSearch::RequestSearch(const MotionSearch::Params& params,
                             const MotionRequest& request, ArmScene scene)
    : params_(params),
      request_(request),
      scene_(std::move(scene)),
      arm_(*params.layout.FindArm(request.arm)),
      state_(request.arms.at(request.arm)),
      reach_(ReachParamsOf(params)) {
  for (const ArmLayout& other : params.layout.arms) {
    if (other.name == arm_.name) continue;
    const ArmPosture home = HomePosture(other);
    if (IsSame(scene_.PostureOf(other.name), home)) continue;
    if (!later_) later_ = scene_;
    later_->SetPosture(other.name, home);
  }
}

/// What other arms are in the way of now can be done when they have gone home.
template <class Find>
auto RequestSearch::NowOrLater(const Find& find) const {
  auto now = find(scene_);
  if (now || !later_) return now;
  auto later = find(*later_);
  return later ? later : now;
}

MotionPlan RequestSearch::FindWay(const ArmPosture& from,
                                  const Joints& to) const {
  return NowOrLater([&](const ArmScene& scene) {
    JointPath path = PlanWay(scene, arm_.name, from, to, params_.motion);
    MotionPlan plan;
    plan.reason = path.reason();
    if (path) plan.waypoints = *std::move(path);
    return plan;
  });
}

MotionPlan RequestSearch::FindGrasp() const {
  const Joints& q = state_.posture.q;
  const auto plan = [&](const GraspChoice& grasp) {
    MotionPlan way = FindWay({q, grasp.grip, grasp.opening}, grasp.q_approach);
    way.grasp = grasp;
    return way;
  };
  const auto choices = [&](size_t most) {
    return NowOrLater(
        [&](const ArmScene& scene) { return GraspsIn(scene, most); });
  };
  return BestWithWay(arm_, choices, plan);
}

Choices<GraspChoice> RequestSearch::GraspsIn(const ArmScene& scene,
                                             size_t most) const {
  const Joints& q = state_.posture.q;
  ReachParams params = reach_;
  params.max_choices = most;
  const Reach reach(scene, arm_.name, params);
  if (!request_.target) return reach.Grasps(request_.part, q);
  const auto transfers = reach.Transfers(request_.part, *request_.target, q,
                                         most == kAll ? kAll : kBestTransfers);
  if (!transfers) return Reason{transfers.reason()};
  std::vector<GraspChoice> grasps;
  for (const auto& transfer : *transfers) grasps.push_back(transfer.grasp);
  return grasps;
}

MotionPlan RequestSearch::FindPlacement(const PlaceTarget& target) const {
  const auto plan = [&](const PlaceChoice& place) {
    MotionPlan way = FindWay(state_.posture, place.q_approach);
    way.target = target;
    way.X_WO = place.X_WO;
    return way;
  };
  const auto choices = [&](size_t most) {
    return NowOrLater(
        [&](const ArmScene& scene) { return PlacesIn(scene, target, most); });
  };
  return BestWithWay(arm_, choices, plan);
}

Choices<PlaceChoice> RequestSearch::PlacesIn(const ArmScene& scene,
                                             const PlaceTarget& target,
                                             size_t most) const {
  ReachParams params = reach_;
  params.max_choices = most;
  const Reach reach(scene, arm_.name, params);
  const ArmPosture& posture = state_.posture;
  const auto places =
      reach.Placements(state_.held->part, state_.held->X_GO, posture.grip,
                       posture.opening, target, posture.q);
  if (!places) return Reason{"its place: " + places.reason()};
  return places;
}

MotionPlan RequestSearch::FindSetDown() const {
  const auto place =
      NowOrLater([&](const ArmScene& scene) { return FreePlaceIn(scene); });
  if (place) return FindPlacement(*place);
  MotionPlan none;
  none.reason = place.reason();
  return none;
}

Result<PlaceTarget> RequestSearch::FreePlaceIn(const ArmScene& scene) const {
  const Part& part = *params_.parts.Find(state_.held->part);
  const double bottom = PartShape(part).LowestZ(Isometry3d::Identity());
  // The parts' table turns those by itself that look the same all round.
  const int num_yaws = part.symmetry_order == 0 ? 1 : kYaws;
  PlaceTarget target;
  target.approach = params_.motion.approach;
  for (const double apart : kApart) {
    for (const Vector2d& p : PointsIn(request_.area)) {
      for (int i = 0; i < num_yaws; ++i) {
        target.X_WO =
            Translation3d(p.x(), p.y(), kOverTable - bottom) *
            AngleAxisd(2 * std::numbers::pi * i / num_yaws, Vector3d::UnitZ());
        const auto near = scene.Neighbours(part.name, target.X_WO, apart);
        if (near.size() > 1) continue;  // than the table
        if (PlacesIn(scene, target, 1) &&
            (!request_.is_for_other_arm || CanOtherTake(scene, target.X_WO))) {
          return target;
        }
      }
    }
  }
  return Reason{
      request_.is_for_other_arm
          ? "there is no free place on the table for the other arm to take "
            "it from"
          : "there is no free place on the table"};
}

/// True if the other arm can take the held part when that lies at X_WO and all
/// arms are at home.
bool RequestSearch::CanOtherTake(const ArmScene& scene,
                                 const Isometry3d& X_WO) const {
  ArmScene then = scene;
  then.LetGo(arm_.name);
  then.PutPart(state_.held->part, X_WO);
  for (const ArmLayout& arm : params_.layout.arms) {
    then.SetPosture(arm.name, HomePosture(arm));
  }
  return std::ranges::any_of(params_.layout.arms, [&](const ArmLayout& other) {
    if (other.name == arm_.name) return false;
    const Reach reach(then, other.name, reach_);
    return bool(reach.Grasps(state_.held->part, other.home));
  });
}

}  // namespace cell::motion_planner
