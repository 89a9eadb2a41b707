#include "services/cell/scoring/collision_check.h"

#include <utility>

#include "common/arms/arm_bodies.h"
#include "common/geometry/pose.h"

namespace cell::cli {
namespace {

// [m] Nearer is touching: contacts in the physics are as deep as that.
constexpr double kContact = 1e-4;
constexpr double kInHand = 0.003;  // [m] as near are the fingers that hold it
constexpr char kTable[] = "table";

}  // namespace

CollisionCheck::CollisionCheck(const CellLayout& layout,
                               const PartTable& parts) {
  for (const Part& part : parts.parts()) Add(part);
  num_parts_ = pedestal_ = bodies_.size();
  Add(PedestalBody(layout.pedestal));
  bodies_.back().X_WB = layout.pedestal.X_WP;
  bodies_.back().is_there = true;
  for (const ArmLayout& arm : layout.arms) {
    const size_t plinth = bodies_.size();
    for (const Part& body : BodyPartsOf(arm)) Add(body);
    arms_.push_back({arm.name, plinth, plinth + ArmModel::kFirstLinkBody,
                     plinth + ArmModel::kNumBodies, bodies_.size(), arm.model});
  }
  first_of_hands_ = bodies_.size();
  for (const CellLayout::Hand& hand : layout.hands) {
    for (const Part& box : HandPartsOf(hand.name, hand.type)) Add(box);
  }
}

void CollisionCheck::Add(const Part& part) {
  indices_[part.name] = bodies_.size();
  bodies_.push_back({part.name, PartShape(part)});
}

void CollisionCheck::Pose(const truth_poses_t& poses) {
  for (Body& body : bodies_) body.is_there = false;
  bodies_[pedestal_].is_there = true;
  for (const body_pose_t& posed : poses.bodies) {
    const auto found = indices_.find(posed.name);
    if (found == indices_.end() || found->second == pedestal_) continue;
    Body& body = bodies_[found->second];
    const auto X_WB = PoseFromMessage(posed.pose_world_body);
    body.is_there = X_WB.has_value();
    if (X_WB) body.X_WB = *X_WB;
  }
}

std::vector<CollisionCheck::Touch> CollisionCheck::Look(
    const truth_poses_t& poses,
    const std::map<std::string, ArmActivity>& activities) {
  touches_.clear();
  Pose(poses);
  for (const Arm& arm : arms_) {
    const auto found = activities.find(arm.name);
    const ArmActivity activity =
        found == activities.end() ? ArmActivity() : found->second;
    for (size_t body = arm.first_link; body < arm.end; ++body) {
      const bool is_hand = body >= arm.first_box;
      LookAround(arm, body, is_hand ? activity.grasped() : "");
    }
    LookAtItself(arm);
    LookAtHeld(arm, activity);
  }
  return std::move(touches_);
}

bool CollisionCheck::Touches(size_t a, size_t b) const {
  const Body& first = bodies_[a];
  const Body& second = bodies_[b];
  return first.is_there && second.is_there &&
         PartShape::Distance(first.shape, first.X_WB, second.shape, second.X_WB,
                             kContact) < kContact;
}

bool CollisionCheck::TouchesTable(size_t body) const {
  return bodies_[body].is_there &&
         bodies_[body].shape.LowestZ(bodies_[body].X_WB) < kContact;
}

/// A link, or a box of the hand that may touch `grasped`.
void CollisionCheck::LookAround(const Arm& arm, size_t body,
                                const std::string& grasped) {
  if (TouchesTable(body)) {
    touches_.push_back({arm.name, bodies_[body].name, kTable});
  }
  for (size_t part = 0; part < num_parts_; ++part) {
    if (bodies_[part].name != grasped) Report(arm, body, part);
  }
  Report(arm, body, pedestal_);
  for (const Arm& other : arms_) {
    if (other.plinth == arm.plinth) continue;
    // Pairs of moving bodies are checked once.
    const size_t end = arm.plinth < other.plinth ? other.end : other.first_link;
    for (size_t i = other.plinth; i < end; ++i) Report(arm, body, i);
  }
}

void CollisionCheck::LookAtItself(const Arm& arm) {
  for (size_t body = arm.first_link; body < arm.end; ++body) {
    for (size_t inner = arm.plinth; inner < body; ++inner) {
      if (arm.model->MayCollide(inner - arm.plinth, body - arm.plinth)) {
        Report(arm, body, inner);
      }
    }
  }
}

/// What an arm holds. Links and hands are checked as bodies of their arms.
void CollisionCheck::LookAtHeld(const Arm& arm, const ArmActivity& activity) {
  const auto found = indices_.find(activity.held());
  if (found == indices_.end() || found->second >= num_parts_) return;
  const size_t held = found->second;
  if (!activity.IsHeldAtTable() && TouchesTable(held)) {
    touches_.push_back({arm.name, bodies_[held].name, kTable});
  }
  if (!activity.IsHeldAmongParts()) {
    for (size_t i = 0; i <= pedestal_; ++i) {
      if (i != held) Report(arm, held, i);
    }
  }
  for (const Arm& any : arms_) {
    for (size_t i = any.plinth; i < any.first_link; ++i) Report(arm, held, i);
  }
}

void CollisionCheck::Report(const Arm& arm, size_t first, size_t second) {
  if (!Touches(first, second)) return;
  touches_.push_back({arm.name, bodies_[first].name, bodies_[second].name,
                      second < num_parts_ && IsInPersonsHand(second)});
}

bool CollisionCheck::IsInPersonsHand(size_t part) const {
  const Body& held = bodies_[part];
  for (size_t i = first_of_hands_; i < bodies_.size(); ++i) {
    const Body& box = bodies_[i];
    if (box.is_there && PartShape::Distance(held.shape, held.X_WB, box.shape,
                                            box.X_WB, kInHand) < kInHand) {
      return true;
    }
  }
  return false;
}

}  // namespace cell::cli
