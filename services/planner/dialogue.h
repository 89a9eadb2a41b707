#pragma once

#include <cstdint>
#include <optional>

#include "services/planner/decisions.h"
#include "services/planner/observations.h"

namespace cell::planner {

/// The messages and questions to the person while the robot does a task: when
/// the robot's patience ends, and when the person has done what was asked for.
class Dialogue {
 public:
  explicit Dialogue(int64_t patience_us) : patience_us_(patience_us) {}

  /// True while an undecidable state, first reported now or earlier, may still
  /// be resolved by itself.
  bool IsPatient(Instant now);
  /// Reports the question about `state`, once.
  void Ask(ExecutionStatus question, const State& state, Instant now,
           Decisions& out);
  bool is_asking() const { return asked_utime_.has_value(); }
  /// True while the person is at what was asked for and the state may look odd:
  /// it has changed since, and has not stayed as it is for so long.
  bool IsPersonAtWork(const State& state, Instant now);
  /// True if it answers the question: what is there now is to be looked at.
  bool OnAction(const DoneAction& action);
  /// The question is settled: an arm does something, or the goal is reached.
  void OnStart();
  /// The goal is another one.
  void OnGoal();

  /// Reports the status, if it is another one than the last.
  void Report(ExecutionStatus status, Instant now, Decisions& out);

 private:
  struct Topic {
    State state;              // that the question was about
    State latest;             // another one ...
    int64_t since_utime = 0;  // ... that has stayed since then
  };

  int64_t patience_us_;
  std::optional<int64_t> undecided_utime_;  // since when
  std::optional<int64_t> asked_utime_;      // since when
  std::optional<Topic> topic_;              // until the person has acted
  std::optional<ExecutionStatus> reported_;
};

}  // namespace cell::planner
