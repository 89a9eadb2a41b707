#include "services/robot_arm/stage_runner.h"

#include <utility>

namespace cell::robot_arm {

void StageRunner::Clear() {
  stage_.reset();
  other_way_.reset();
  pending_.clear();
}

StageRunner::Status StageRunner::Step(const ArmReading& reading, double dt,
                                      ArmCommand* command) {
  failure_ = {};
  if (!stage_ && !BeginNext()) {
    return failure_.reason.empty() ? Status::kDone : Fail(failure_);
  }
  other_way_.reset();
  switch (stage_->Step(reading, dt, command)) {
    case SkillStage::State::kWaiting:
      break;
    case SkillStage::State::kRunning:
      has_moved_ |= dt > 0;
      break;
    case SkillStage::State::kFailed:
      return Fail(stage_->failure());
    case SkillStage::State::kDone:
      stage_.reset();
      FinishFirst();
  }
  return Status::kRunning;
}

/// Makes the next stage; false if there is none, or if it cannot be made.
bool StageRunner::BeginNext() {
  while (!pending_.empty()) {
    phase_ = pending_.front().phase;
    Made made = pending_.front().make();
    if (!made) {
      failure_ = {made.reason().empty() ? "it cannot be done" : made.reason()};
      return false;
    }
    stage_ = *std::move(made);
    if (stage_) return true;
    FinishFirst();
  }
  return false;
}

void StageRunner::FinishFirst() {
  const auto then = std::move(pending_.front().then);
  pending_.pop_front();
  if (then) then();
}

StageRunner::Status StageRunner::Fail(const Failure& failure) {
  failure_ = failure;
  Clear();
  return Status::kFailed;
}

/// If there is no other way it keeps to the one that it has.
void StageRunner::SeekOtherWay() {
  if (!stage_ || !stage_->HasOtherWays()) return;
  Made made = pending_.front().make();
  if (made) other_way_ = *std::move(made);
}

void StageRunner::TryOtherWay(double dt) {
  if (!other_way_) return;
  switch (other_way_->Prepare(dt)) {
    case SkillStage::State::kWaiting:
      return;
    case SkillStage::State::kFailed:
      return other_way_.reset();
    default:
      stage_ = std::move(other_way_);
  }
}

std::vector<std::optional<Joints>> StageRunner::Ahead(
    const std::vector<double>& seconds, const Joints& q) const {
  std::vector<std::optional<Joints>> way;
  for (const double ahead : seconds) {
    if (stage_) way.push_back(stage_->Ahead(ahead, q));
  }
  return way;
}

}  // namespace cell::robot_arm
