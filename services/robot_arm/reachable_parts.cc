#include "services/robot_arm/reachable_parts.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;

constexpr double kMoved = 0.002;  // [m] a part has moved
constexpr double kTurned = 0.01;  // [rad] or turned

}  // namespace

bool HasMoved(const Isometry3d& X_WO_before, const Isometry3d& X_WO_now) {
  return (X_WO_before.translation() - X_WO_now.translation()).norm() >=
             kMoved ||
         Eigen::AngleAxisd(X_WO_before.linear().transpose() * X_WO_now.linear())
                 .angle() >= kTurned;
}

void ReachableParts::Update(const std::map<std::string, Isometry3d>& poses) {
  resting_.clear();
  for (const auto& [name, X_WO] : poses) {
    const auto before = seen_.find(name);
    if (before == seen_.end() || !HasMoved(before->second, X_WO)) {
      resting_.push_back(name);
    }
  }
  seen_ = poses;
}

void ReachableParts::Step(double dt) {
  if (!inquiry_) return AskNext();
  const MotionInquiry::State state = inquiry_->Step(dt);
  if (state == MotionInquiry::State::kWaiting) return;
  if (!inquiry_->is_answered()) {
    for (const std::string& part : wanted_) asked_.erase(part);
    return inquiry_.reset();
  }
  for (const std::string& part : wanted_) reachable_.erase(part);
  for (const std::string& part : inquiry_->plan().reachable) {
    reachable_.insert(part);
  }
  inquiry_.reset();
}

/// About all that have come to rest elsewhere.
void ReachableParts::AskNext() {
  wanted_.clear();
  for (const std::string& name : resting_) {
    const Isometry3d& X_WO = seen_.at(name);
    const auto known = asked_.find(name);
    if (parts_.Find(name)->is_fixed ||
        (known != asked_.end() && !HasMoved(known->second, X_WO))) {
      continue;
    }
    asked_.insert_or_assign(name, X_WO);
    wanted_.push_back(name);
  }
  if (wanted_.empty()) return;
  MotionRequest request = monitor_.MakeRequest(MotionRequest::Kind::kReach, {});
  request.wanted = wanted_;
  inquiry_ = std::make_unique<MotionInquiry>(client_, request);
}

std::vector<std::string> ReachableParts::List() const {
  std::vector<std::string> reachable;
  for (const std::string& part : reachable_) {
    if (monitor_.poses().contains(part) && !monitor_.IsInHand(part)) {
      reachable.push_back(part);
    }
  }
  return reachable;
}

}  // namespace cell::robot_arm
