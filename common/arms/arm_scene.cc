#include "common/arms/arm_scene.h"

#include <fmt/format.h>

#include <stdexcept>

#include "common/arms/ur5.h"

namespace cell {
namespace {

using Eigen::Isometry3d;

constexpr size_t kPlinth = 0, kBase = 1, kFirstLink = 2;

Part PedestalBox(const CellLayout::Pedestal& pedestal) {
  Part part;
  part.name = "pedestal";
  Piece box;
  box.half_extents =
      Eigen::Vector3d(pedestal.size.x(), pedestal.size.y(), pedestal.height) /
      2;
  part.pieces = {box};
  return part;
}

std::string Hit(const std::string& a, const std::string& b) {
  return fmt::format("{} would hit {}", a, b);
}

}  // namespace

ArmScene::ArmScene(const CellLayout& layout, const PartTable& parts,
                   const std::string& arm)
    : layout_(layout), arm_(layout_.FindArm(arm)) {
  if (arm_ == nullptr) throw std::invalid_argument("no arm is named " + arm);
  for (const Part& link : ArmLinks(*arm_)) {
    links_.push_back({link.name, PartShape(link)});
  }
  for (const Part& box : HandBoxes(arm_->gripper, arm_->hand)) {
    boxes_.push_back({box.name, PartShape(box)});
  }
  for (const Part& part : parts.parts()) {
    parts_.push_back({part.name, PartShape(part)});
    parts_.back().is_there = false;
    parts_.back().is_fixed = part.is_fixed;
  }
  const Part pedestal = PedestalBox(layout_.pedestal);
  fixtures_.push_back({pedestal.name, PartShape(pedestal)});
  fixtures_.back().X_WB =
      layout_.pedestal.X_WP *
      Eigen::Translation3d(0, 0, -layout_.pedestal.height / 2);
  for (const ArmLayout& other : layout_.arms) {
    if (other.name != arm) AddOther(other);
  }
}

void ArmScene::AddOther(const ArmLayout& other) {
  std::vector<Body>& bodies = others_[other.name];
  for (const Part& link : ArmLinks(other)) {
    bodies.push_back({link.name, PartShape(link)});
  }
  for (const Part& box : HandBoxes(other.gripper, other.hand)) {
    bodies.push_back({box.name, PartShape(box)});
  }
  SetOther(other.name, {other.home, "", other.hand.max_opening / 2});
}

void ArmScene::SetParts(const std::map<std::string, Isometry3d>& poses) {
  poses_ = poses;
  for (Body& part : parts_) {
    const auto pose = poses_.find(part.name);
    part.is_there = pose != poses_.end();
    if (part.is_there) part.X_WB = pose->second;
  }
}

void ArmScene::SetOther(const std::string& arm, const ArmPosture& posture) {
  const auto it = others_.find(arm);
  if (it == others_.end()) return;
  const ArmLayout& other = *layout_.FindArm(arm);
  std::vector<NamedPose> poses = ArmLinkPoses(other, posture.q);
  const Isometry3d X_WG = other.X_WB * ur5::FlangePose(posture.q) * other.X_FG;
  for (NamedPose& pose : HandBoxPoses(other.gripper, other.hand, X_WG,
                                      posture.grip, posture.opening)) {
    poses.push_back(std::move(pose));
  }
  for (size_t i = 0; i < poses.size(); ++i)
    it->second[i].X_WB = poses[i].second;
}

std::optional<std::string> ArmScene::WhyNot(const ArmPosture& posture,
                                            const Question& question) const {
  std::vector<Moving> links, tool;
  const auto link_poses = ArmLinkPoses(*arm_, posture.q);
  for (size_t i = 0; i < links_.size(); ++i) {
    links.push_back({&links_[i].name, &links_[i].shape, link_poses[i].second});
  }
  const Isometry3d X_WG = arm_->X_WB * ur5::FlangePose(posture.q) * arm_->X_FG;
  const auto box_poses = HandBoxPoses(arm_->gripper, arm_->hand, X_WG,
                                      posture.grip, posture.opening);
  for (size_t i = 0; i < boxes_.size(); ++i) {
    tool.push_back({&boxes_[i].name, &boxes_[i].shape, box_poses[i].second});
  }
  for (size_t i = kFirstLink; i < links.size(); ++i) {
    // The shoulder turns over the plinth and meets nothing.
    if (i == kFirstLink) continue;
    if (auto hit = HitBy(links[i], false, question)) return hit;
  }
  for (const Moving& box : tool) {
    if (auto hit = HitBy(box, true, question)) return hit;
  }
  if (question.held) {
    for (const Body& part : parts_) {
      if (part.name != question.held->part) continue;
      tool.push_back({&part.name, &part.shape, X_WG * question.held->X_GO});
      if (auto hit = HitBy(tool.back(), false, question)) return hit;
    }
  }
  return HitsItself(links, tool, question.clearance);
}

std::optional<std::string> ArmScene::HitBy(const Moving& moving, bool is_hand,
                                           const Question& question) const {
  const double clearance = question.clearance;
  const std::string held = question.held ? question.held->part : "";
  const bool is_held = *moving.name == held;
  const double over_table =
      question.over_table < 0 ? clearance : question.over_table;
  if (moving.shape->LowestZ(moving.X_WB) < (is_held ? 0 : over_table)) {
    return Hit(*moving.name, "the table");
  }
  const auto hits = [&](const Body& body) {
    return PartShape::Distance(*moving.shape, moving.X_WB, body.shape,
                               body.X_WB, clearance) < clearance;
  };
  const bool is_among_parts = !(is_held && question.is_seated);
  for (const Body& part : parts_) {
    if (!is_among_parts || !part.is_there || part.name == held) continue;
    if (question.only_fixed && !part.is_fixed) continue;
    if (is_hand && part.name == question.grasped) continue;
    if (hits(part)) return Hit(*moving.name, part.name);
  }
  for (const Body& fixture : fixtures_) {
    if (is_among_parts && hits(fixture)) return Hit(*moving.name, fixture.name);
  }
  for (const auto& [name, bodies] : others_) {
    if (question.only_fixed) break;
    for (const Body& body : bodies) {
      if (hits(body)) return Hit(*moving.name, body.name);
    }
  }
  return std::nullopt;
}

/// Links that are no neighbours, and what the hand holds up to the forearm.
std::optional<std::string> ArmScene::HitsItself(
    const std::vector<Moving>& links, const std::vector<Moving>& tool,
    double clearance) const {
  const auto hits = [&](const Moving& a, const Moving& b) {
    return PartShape::Distance(*a.shape, a.X_WB, *b.shape, b.X_WB, clearance) <
           clearance;
  };
  const size_t forearm = kFirstLink + 2, upper_arm = kFirstLink + 1;
  for (size_t i = forearm + 1; i < links.size(); ++i) {
    for (size_t j = kPlinth; j <= upper_arm; ++j) {
      if (hits(links[i], links[j])) return Hit(*links[i].name, *links[j].name);
    }
  }
  for (const size_t j : {kPlinth, kBase}) {
    if (hits(links[forearm], links[j])) {
      return Hit(*links[forearm].name, *links[j].name);
    }
  }
  for (const Moving& body : tool) {
    for (size_t j = kPlinth; j <= forearm; ++j) {
      if (hits(body, links[j])) return Hit(*body.name, *links[j].name);
    }
  }
  return std::nullopt;
}

}  // namespace cell
