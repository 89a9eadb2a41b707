#include "common/arms/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/arms/reach_search.h"

namespace cell {
namespace {

using Eigen::Isometry3d;

// The wrist at every 15 deg of a turn.
std::vector<Joints> Turning(const PlaceChoice& choice) {
  constexpr double kStep = std::numbers::pi / 12;
  const Joints way = choice.q_turned - choice.q_place;
  const int num = static_cast<int>(std::ceil(way.norm() / kStep));
  std::vector<Joints> turning;
  for (int i = 1; i <= num; ++i) {
    turning.push_back(choice.q_place + way * i / num);
  }
  return turning;
}

}  // namespace

Reach::Reach(const ArmScene& scene, const std::string& arm,
             const ReachParams& params)
    : scene_(scene),
      arm_name_(arm),
      arm_(scene_.layout().FindArm(arm)),
      params_(params) {
  if (arm_ == nullptr) {
    throw std::invalid_argument(fmt::format("there is no arm '{}'", arm));
  }
  scene_.LetGo(arm);
}

Choices<GraspChoice> Reach::Grasps(const std::string& part_name,
                                   const Joints& seed) const {
  const auto X_WO = scene_.PoseOf(part_name);
  if (!X_WO) return Reason{part_name + " has no known pose to grasp it at"};
  ReachSearch search(*arm_, params_);
  const ClearanceRule open{params_.clearance, {}};
  const ClearanceRule leaving = Grazing(part_name, *X_WO);
  std::vector<GraspChoice> choices;
  for (const auto& [choice, track] :
       search.ToGrasp(*scene_.parts().Find(part_name), *X_WO, seed)) {
    ArmScene holding = scene_;
    holding.Hold(arm_name_, part_name, choice.X_OG.inverse());
    if (!search.IsFree(scene_, track, choice.grip, choice.opening, open) ||
        !search.IsFree(scene_, {choice.q_grasp}, choice.grip, choice.width,
                       Closing(part_name, choice.grip)) ||
        !search.IsFree(holding, track, choice.grip, choice.width, leaving)) {
      continue;
    }
    choices.push_back(choice);
    if (choices.size() == params_.max_choices) break;
  }
  if (choices.empty()) return Reason{search.reason()};
  return choices;
}

Choices<PlaceChoice> Reach::Placements(const std::string& part_name,
                                       const Isometry3d& X_GO,
                                       const std::string& grip, double width,
                                       const PlaceTarget& target,
                                       const Joints& seed) const {
  const Part* part = scene_.parts().Find(part_name);
  if (part == nullptr) return Reason{"there is no part " + part_name};
  ReachSearch search(*arm_, params_);
  ArmScene holding = scene_;
  holding.Hold(arm_name_, part_name, X_GO);
  const ClearanceRule arriving = Grazing(part_name, target.X_WO);
  const ClearanceRule open{params_.clearance, {}};
  const double opening =
      std::min(width + params_.open_margin, arm_->hand.max_opening);
  std::vector<PlaceChoice> choices;
  for (const auto& [choice, track] :
       search.ToPlace(*part, X_GO, target, seed)) {
    ArmScene placed = scene_;
    placed.PutPart(part_name, choice.X_WO);
    if (!search.IsFree(holding, track, grip, width, arriving) ||
        !search.IsFree(holding, Turning(choice), grip, width, arriving) ||
        !search.IsFree(placed, track, grip, opening, open)) {
      continue;
    }
    choices.push_back(choice);
    if (choices.size() == params_.max_choices) break;
  }
  if (choices.empty()) return Reason{search.reason()};
  return choices;
}

ClearanceRule Reach::Closing(const std::string& part,
                             const std::string& grip) const {
  ClearanceRule rule{params_.clearance, {}};
  const auto& places = arm_->hand.FindGrip(grip)->places;
  for (size_t i = 0; i < places.size(); ++i) {
    if (!HandType::IsFinger(places[i])) continue;
    rule.allowed.emplace_back(arm_->gripper + "." + arm_->hand.boxes[i].name,
                              part);
  }
  return rule;
}

ClearanceRule Reach::Grazing(const std::string& part,
                             const Isometry3d& X_WO) const {
  ClearanceRule rule{params_.clearance, {}};
  for (const std::string& neighbour :
       scene_.Neighbours(part, X_WO, params_.touching)) {
    rule.allowed.emplace_back(part, neighbour);
  }
  return rule;
}

Choices<TransferChoice> Reach::Transfers(const std::string& part,
                                         const PlaceTarget& target,
                                         const Joints& seed,
                                         size_t max_choices) const {
  const ArmModel& model = *arm_->model;
  const Choices<GraspChoice> grasps = Grasps(part, seed);
  if (!grasps) return Reason{grasps.reason()};
  std::string reason;
  std::vector<TransferChoice> choices, others;
  for (const GraspChoice& grasp : *grasps) {
    const Choices<PlaceChoice> places =
        Placements(part, grasp.X_OG.inverse(), grasp.grip, grasp.width, target,
                   grasp.q_approach);
    if (!places) {
      if (reason.empty()) reason = places.reason();
      continue;
    }
    for (const PlaceChoice& place : *places) {
      const bool is_same = model.ConfigurationOf(grasp.q_grasp) ==
                           model.ConfigurationOf(place.q_place);
      (is_same ? choices : others).push_back({grasp, place, is_same});
      if (is_same) break;
    }
    if (choices.size() >= max_choices) break;
  }
  choices.insert(choices.end(), others.begin(), others.end());
  if (choices.empty()) return Reason{reason};
  if (choices.size() > max_choices) choices.resize(max_choices);
  return choices;
}

PlaceTarget TargetAt(const Site& site, const Isometry3d& X_WH) {
  PlaceTarget target;
  target.X_WO = X_WH * site.X_HS;
  target.way_out = target.X_WO.linear().col(2);
  target.approach = site.approach;
  return target;
}

}  // namespace cell
