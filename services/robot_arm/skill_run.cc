#include "services/robot_arm/skill_run.h"

#include <fmt/format.h>

#include <utility>

namespace cell::robot_arm {

using Outcome = SkillResult::Outcome;

namespace {

bool IsYielding(const Failure& failure) {
  return failure.cause == Failure::Cause::kPersonInTheWay;
}

}  // namespace

SkillRun::SkillRun(Arm& arm, const Skill& skill, SkillRequest request)
    : arm_(arm), skill_(skill), request_(std::move(request)) {
  Plan();
}

/// First the arm moves clear of what an interrupted skill has left it at.
void SkillRun::Plan() {
  stages_.Clear();
  if (arm_.SiteOfHeld() != nullptr) {
    LetGo();
    return Add(
        {"look"}, [] { return std::unique_ptr<SkillStage>(); },
        [this] { Plan(); });
  }
  if (arm_.is_near.value_or(false)) GoFree();
  skill_.Plan(*this);
}

std::optional<SkillResult> SkillRun::Step(double dt) {
  switch (stages_.Step(arm_.reading(), dt, &arm_.command())) {
    case StageRunner::Status::kRunning:
      return std::nullopt;
    case StageRunner::Status::kFailed:
      return Fail(stages_.failure());
    case StageRunner::Status::kDone:
      break;
  }
  if (!failure_) return End(Outcome::kSucceeded, "");
  return End(IsYielding(*failure_) ? Outcome::kYielded : Outcome::kFailed,
             failure_->reason);
}

std::optional<SkillResult> SkillRun::Fail(const Failure& failure) {
  stages_.Clear();
  arm_.is_releasing = false;
  if (!stages_.has_moved()) {
    return End(IsYielding(failure) ? Outcome::kYielded : Outcome::kRefused,
               failure.reason);
  }
  if (failure_) {
    return End(Outcome::kFailed, fmt::format("{}; and then: {}",
                                             failure_->reason, failure.reason));
  }
  failure_ = failure;
  const bool is_near = arm_.is_near.value_or(false);
  if (is_near && !arm_.held() && !arm_.reading().is_gripping) {
    const double open = arm_.command().opening + kLetGoMargin * 2;
    Add({"open"}, [=, this] { return Fingers(open, Until::kThere); });
  }
  if (arm_.SiteOfHeld() != nullptr) {
    LetGo();
  } else if (is_near) {
    DrawBack();
  }
  if (skill_.traits().leaves_room_after_failure) GoHome();
  return std::nullopt;
}

SkillResult SkillRun::Stop(const std::string& reason) const {
  return End(Outcome::kStopped, reason);
}

SkillResult SkillRun::End(Outcome outcome, const std::string& reason) const {
  return {request_.id, outcome, reason, peak_force_};
}

}  // namespace cell::robot_arm
