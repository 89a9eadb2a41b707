#include "common/arms/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kAligned = 0.999;  // cosine of axes that count as one

Isometry3d TurnedAboutZ(double angle) {
  return Isometry3d(AngleAxisd(angle, Vector3d::UnitZ()));
}

// The reason of the attempt that came farthest.
class Reasons {
 public:
  enum Stage {
    kGrip,
    kHand,
    kReach,
    kLimits,
    kSingular,
    kWorkspace,
    kCollision
  };
  void Add(Stage stage, const std::string& text) {
    if (!text_.empty() && stage <= stage_) return;
    stage_ = stage;
    text_ = text;
  }
  const std::string& text() const { return text_; }

 private:
  Stage stage_ = kGrip;
  std::string text_;
};

// Joints for a straight way, before anybody looked for collisions.
template <class Choice>
struct Candidate {
  Choice choice;
  std::vector<Joints> track;  // from the end of the way back to its begin
};

template <class Choice>
void SortByCost(std::vector<Candidate<Choice>>* candidates) {
  std::ranges::stable_sort(*candidates, {}, [](const Candidate<Choice>& c) {
    return c.choice.cost;
  });
}

// A long way from the seed is bad, and so is a joint near its limit.
double CostOf(const Joints& q, const Joints& seed) {
  constexpr double kLimitWeight = 0.2;  // [rad^2]
  return (q - seed).norm() + kLimitWeight / std::max(ur5::LimitMargin(q), 0.01);
}

}  // namespace

// One question to Reach: its candidates, and why others are none.
struct Reach::Search {
  using GraspCandidates = std::vector<Candidate<GraspChoice>>;
  using PlaceCandidates = std::vector<Candidate<PlaceChoice>>;

  // Best first.
  GraspCandidates ToGrasp(const Part& part, const Isometry3d& X_WO,
                          const Joints& seed);
  PlaceCandidates ToPlace(const Part& part, const Isometry3d& X_GO,
                          const PlaceTarget& target, const Joints& seed);
  bool Suits(const GraspChoice& choice);
  // Every straight way of the gripper from X_WG_begin to X_WG_end; `turn` [rad]
  // of joint 6 must be possible at its end.
  std::vector<std::vector<Joints>> Tracks(const Isometry3d& X_WG_begin,
                                          const Isometry3d& X_WG_end,
                                          const Joints& seed, double turn);
  // True if joint 6 has that room, at a whole turn from where it is.
  bool FindRoom(Joints* q, double turn) const;
  // True if the arm may stand so all along the track.
  bool IsFree(const ArmScene& scene, const std::vector<Joints>& track,
              const std::string& grip, double opening,
              const ClearanceRule& rule);

  const Reach& reach;
  Reasons reasons{};
};

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

bool Reach::Search::FindRoom(Joints* q, double turn) const {
  const double limit = ur5::kJointLimit - reach.params_.line.joint_margin;
  // Of the copies of joint 6 the first that is near enough to its place.
  for (const double whole : {0.0, 2 * kPi, -2 * kPi}) {
    const double begin = (*q)[5] + whole;
    if (std::abs(begin) > limit || std::abs(begin + turn) > limit) continue;
    (*q)[5] = begin;
    return (*q).cwiseAbs().maxCoeff() <= limit;
  }
  return false;
}

std::vector<std::vector<Joints>> Reach::Search::Tracks(
    const Isometry3d& X_WG_begin, const Isometry3d& X_WG_end,
    const Joints& seed, double turn) {
  const ArmLayout& arm = *reach.arm_;
  std::vector<std::vector<Joints>> tracks;
  if (!arm.workspace.contains(X_WG_begin.translation()) ||
      !arm.workspace.contains(X_WG_end.translation())) {
    reasons.Add(Reasons::kReach, "outside the arm's workspace");
    return tracks;
  }
  const auto solutions =
      ur5::SolveInverse(FlangePoseFor(arm, X_WG_end), seed[5]);
  if (solutions.empty()) reasons.Add(Reasons::kReach, "out of reach");
  for (const Joints& solution : solutions) {
    Joints q = ur5::NearestTo(seed, solution);
    if (!FindRoom(&q, turn)) {
      reasons.Add(Reasons::kLimits, "beyond a joint limit");
      continue;
    }
    StraightLine line = TrackLine(arm, q, X_WG_begin, reach.params_.line);
    if (!line) {
      reasons.Add(Reasons::kSingular, line.reason);
      continue;
    }
    tracks.push_back(std::move(line.track));
  }
  return tracks;
}

bool Reach::Search::IsFree(const ArmScene& scene,
                           const std::vector<Joints>& track,
                           const std::string& grip, double opening,
                           const ClearanceRule& rule) {
  for (const Joints& q : track) {
    if (const auto why =
            scene.WhyBlocked(reach.arm_name_, {q, grip, opening}, rule)) {
      reasons.Add(Reasons::kCollision, *why);
      return false;
    }
  }
  return true;
}

bool Reach::Search::Suits(const GraspChoice& choice) {
  const HandType& hand = reach.arm_->hand;
  if (hand.FindGrip(choice.grip) == nullptr) {
    reasons.Add(Reasons::kGrip, "the hand cannot grip like that");
    return false;
  }
  if (choice.opening > hand.max_opening) {
    reasons.Add(Reasons::kHand, "too wide for the hand");
    return false;
  }
  return true;
}

Reach::Search::GraspCandidates Reach::Search::ToGrasp(const Part& part,
                                                      const Isometry3d& X_WO,
                                                      const Joints& seed) {
  const ReachParams& params = reach.params_;
  GraspCandidates candidates;
  const auto add = [&](GraspChoice choice, double preference) {
    const Isometry3d X_WG = X_WO * choice.X_OG;
    const Isometry3d X_WG_begin =
        X_WG * Eigen::Translation3d(0, 0, params.approach);
    for (auto& track : Tracks(X_WG_begin, X_WG, seed, 0)) {
      choice.q_grasp = track.front();
      choice.q_approach = track.back();
      choice.cost = CostOf(choice.q_approach, seed) + preference;
      candidates.push_back({choice, std::move(track)});
    }
  };
  for (size_t i = 0; i < part.grasps.size(); ++i) {
    const Grasp& grasp = part.grasps[i];
    for (size_t rank = 0; rank < grasp.grips.size(); ++rank) {
      GraspChoice choice{i, grasp.grips[rank], grasp.width + params.open_margin,
                         grasp.width};
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

Reach::Search::PlaceCandidates Reach::Search::ToPlace(const Part& part,
                                                      const Isometry3d& X_GO,
                                                      const PlaceTarget& target,
                                                      const Joints& seed) {
  const int num_copies =
      part.symmetry_order == 0 ? reach.params_.free_turns : part.symmetry_order;
  PlaceCandidates candidates;
  for (int i = 0; i < num_copies; ++i) {
    PlaceChoice choice;
    choice.X_WO = target.X_WO * TurnedAboutZ(2 * kPi * i / num_copies);
    const Isometry3d X_WG = choice.X_WO * X_GO.inverse();
    // Joint 6 turns about z of the flange, against z of G.
    const double along = -X_WG.linear().col(2).dot(target.way_out);
    if (target.turn != 0 && std::abs(along) < kAligned) {
      reasons.Add(Reasons::kHand, "the grip is off the axis to turn about");
      continue;
    }
    const Isometry3d X_WG_begin =
        Eigen::Translation3d(target.approach * target.way_out) * X_WG;
    const double turn = std::copysign(1.0, along) * target.turn;
    for (auto& track : Tracks(X_WG_begin, X_WG, seed, turn)) {
      choice.q_place = track.front();
      choice.q_approach = track.back();
      choice.cost = CostOf(choice.q_approach, seed);
      candidates.push_back({choice, std::move(track)});
    }
  }
  SortByCost(&candidates);
  return candidates;
}

Choices<GraspChoice> Reach::Grasps(const std::string& part_name,
                                   const Joints& seed) const {
  const auto X_WO = scene_.PoseOf(part_name);
  if (!X_WO) return {{}, part_name + " is nowhere to be taken from"};
  Search search{*this};
  const ClearanceRule open{params_.clearance, {}};
  const ClearanceRule leaving = Grazing(part_name, *X_WO);
  Choices<GraspChoice> choices;
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
    choices.list.push_back(choice);
    if (choices.list.size() == params_.max_choices) break;
  }
  if (!choices) choices.reason = search.reasons.text();
  return choices;
}

Choices<PlaceChoice> Reach::Placements(const std::string& part_name,
                                       const Isometry3d& X_GO,
                                       const std::string& grip, double width,
                                       const PlaceTarget& target,
                                       const Joints& seed) const {
  const Part* part = scene_.parts().Find(part_name);
  if (part == nullptr) return {{}, "there is no part " + part_name};
  Search search{*this};
  ArmScene holding = scene_;
  holding.Hold(arm_name_, part_name, X_GO);
  const ClearanceRule arriving = Grazing(part_name, target.X_WO);
  const ClearanceRule open{params_.clearance, {}};
  const double opening =
      std::min(width + params_.open_margin, arm_->hand.max_opening);
  Choices<PlaceChoice> choices;
  for (const auto& [choice, track] :
       search.ToPlace(*part, X_GO, target, seed)) {
    ArmScene placed = scene_;
    placed.PutPart(part_name, choice.X_WO);
    if (!search.IsFree(holding, track, grip, width, arriving) ||
        !search.IsFree(placed, track, grip, opening, open)) {
      continue;
    }
    choices.list.push_back(choice);
    if (choices.list.size() == params_.max_choices) break;
  }
  if (!choices) choices.reason = search.reasons.text();
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
  const Choices<GraspChoice> grasps = Grasps(part, seed);
  Choices<TransferChoice> choices;
  choices.reason = grasps.reason;
  std::vector<TransferChoice> others;
  for (const GraspChoice& grasp : grasps.list) {
    const Choices<PlaceChoice> places =
        Placements(part, grasp.X_OG.inverse(), grasp.grip, grasp.width, target,
                   grasp.q_approach);
    if (choices.reason.empty()) choices.reason = places.reason;
    for (const PlaceChoice& place : places.list) {
      const bool is_same =
          ur5::BranchOf(grasp.q_grasp) == ur5::BranchOf(place.q_place);
      (is_same ? choices.list : others).push_back({grasp, place, is_same});
      if (is_same) break;
    }
    if (choices.list.size() >= max_choices) break;
  }
  choices.list.insert(choices.list.end(), others.begin(), others.end());
  if (choices.list.size() > max_choices) choices.list.resize(max_choices);
  if (choices) choices.reason.clear();
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
