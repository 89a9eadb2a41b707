#include "services/planner/dialogue.h"

#include <utility>

namespace cell::planner {

bool Dialogue::IsPatient(Instant now) {
  if (!undecided_utime_) undecided_utime_ = now.utime;
  return now.utime - *undecided_utime_ < patience_us_;
}

void Dialogue::Ask(ExecutionStatus question, const State& state, Instant now,
                   Decisions& out) {
  if (!asked_utime_) asked_utime_ = now.utime;
  if (!topic_) topic_ = Topic{state, state, now.utime};
  Report(std::move(question), now, out);
}

bool Dialogue::IsPersonAtWork(const State& state, Instant now) {
  if (!topic_ || state == topic_->state) return false;
  if (state != topic_->latest) {
    topic_->latest = state;
    topic_->since_utime = now.utime;
  }
  if (now.utime - topic_->since_utime < patience_us_) return true;
  topic_.reset();
  return false;
}

bool Dialogue::OnAction(const DoneAction& action) {
  if (!asked_utime_ || action.pick_utime < *asked_utime_) return false;
  topic_.reset();
  undecided_utime_.reset();  // what it means may not be known at once
  return true;
}

void Dialogue::OnStart() {
  asked_utime_.reset();
  undecided_utime_.reset();
}

void Dialogue::OnGoal() {
  OnStart();
  topic_.reset();
}

void Dialogue::Report(ExecutionStatus status, Instant now, Decisions& out) {
  if (reported_ == status) return;
  if (status.state == ExecutionStatus::State::kStuck) {
    out.alerts.push_back(
        {Alert::Cause::kStuck, now.utime, "The robot asks: " + status.text});
  }
  reported_ = status;
  out.execution = std::move(status);
}

}  // namespace cell::planner
