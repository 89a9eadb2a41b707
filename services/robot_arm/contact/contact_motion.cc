#include "services/robot_arm/contact/contact_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell::robot_arm {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

ContactMotion::ContactMotion(const Params& params,
                             std::unique_ptr<MotionReference> reference,
                             std::unique_ptr<Termination> termination,
                             const Isometry3d& X_SO)
    : reference_(std::move(reference)),
      termination_(std::move(termination)),
      admittance_(params.admittance),
      slow_down_(params.slow_down),
      search_(params.search),
      dither_(params.dither),
      stall_(params.stall, X_SO.translation().z()),
      limits_(params.limits),
      step_{.R_SO = X_SO.linear()},
      p_SO_(X_SO.translation()) {}

ContactMotion::State ContactMotion::Step(const ContactWrench& contact,
                                         double height, double dt) {
  if (state_ != State::kRunning) return state_;
  time_ += dt;
  peak_force_ = std::max(peak_force_, contact.force.norm());
  stall_.Step(contact.force.z(), reference_->push(), height, dt);
  const ContactState now{contact, height, p_SO_.z(), step_.turned,
                         stall_.is_stalled()};
  Judge(now);
  if (state_ == State::kRunning) MoveOn(now, dt);
  return state_;
}

void ContactMotion::Fail(const std::string& reason) {
  state_ = State::kFailed;
  reason_ = reason;
}

void ContactMotion::Judge(const ContactState& now) {
  if (const auto why =
          limits_.WhyExceeded(now.contact.force.norm(), time_,
                              termination_->DistanceLeft(now.height))) {
    return Fail(*why);
  }
  const Termination::Verdict verdict = termination_->Judge(now);
  switch (verdict.outcome) {
    case Termination::Outcome::kGoOn:
      return;
    case Termination::Outcome::kDone:
      state_ = State::kDone;
      return;
    case Termination::Outcome::kFailed:
      return Fail(verdict.reason);
    case Termination::Outcome::kStuck:
      if (!search_.is_enabled()) return Fail(verdict.reason);
      search_.Begin(now.height);
  }
}

/// Eq. 2: what the reference and what force control along z ask for add up in
/// p_SO_, the offsets sideways and in rotation come on top (PartPose()).
void ContactMotion::MoveOn(const ContactState& now, double dt) {
  const double rate = slow_down_.Rate(now.contact.force.head<2>());
  step_ = reference_->Advance(now, rate, dt);
  Vector3d move = step_.translation;
  if (step_.is_pressing) {
    const double error = now.contact.force.z() - reference_->push();
    move.z() += admittance_.AxialStep(error, rate, dt);
  }
  p_SO_ += move;
  admittance_.Step(now.contact, dt);
  Search(now, dt);
  dither_.Step(stall_.is_stalling() || search_.is_searching(), dt);
}

void ContactMotion::Search(const ContactState& now, double dt) {
  switch (search_.Step(now.height, dt)) {
    case SpiralSearch::State::kIdle:
    case SpiralSearch::State::kSearching:
      return;
    case SpiralSearch::State::kFound:
      return stall_.Reset();
    case SpiralSearch::State::kExhausted:
      Fail(fmt::format(
          "{} searches, the maximum allowed (search.max_spirals), found no way "
          "in, {:.1f} mm "
          "from the seat",
          search_.max_spirals(), 1e3 * termination_->DistanceLeft(now.height)));
  }
}

Isometry3d ContactMotion::PartPose() const {
  const Vector2d yielded =
      search_.middle() + admittance_.proportional() + admittance_.integral();
  Isometry3d X_SO = Isometry3d::Identity();
  X_SO.translation() = p_SO_;
  X_SO.translation().head<2>() += yielded;
  X_SO.translation().head<2>() += search_.Circle();
  const Vector3d turn = admittance_.Turn() + dither_.Turn(time_);
  const double angle = turn.norm();
  X_SO.linear() = step_.R_SO;
  if (angle > 0) {
    X_SO.linear() = Eigen::AngleAxisd(angle, turn / angle) * step_.R_SO;
  }
  return X_SO;
}

}  // namespace cell::robot_arm
