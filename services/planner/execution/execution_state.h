#pragma once

#include <memory>
#include <string_view>

#include "services/planner/execution/execution_context.h"

namespace cell::planner {

/// A state of the robot's execution. Each is a file of this folder.
///
///        a goal                                    the person has acted
///          |                                 +----------- AwaitPerson
///          v                                 v                 ^
///      AwaitRest ----> Await ----> Sense --> Act --> Undecided | the state
///           arms are      one may    fresh   | ^  no sure |    | changes
///           at rest       begin      state   | |   plan   v    |
///                                            | |         Ask --+
///          Done <----- CleanUp <-------------+ +--- other plan
///             arms are home      goal reached
///
/// From Sense, Act, Undecided, Ask and AwaitPerson it goes back to Await if no
/// arm may begin anything, and to Sense if the state is not fresh. Act asks at
/// once for a step that is left to the person.
class ExecutionState {
 public:
  ExecutionState() = default;
  ExecutionState(const ExecutionState&) = delete;
  ExecutionState& operator=(const ExecutionState&) = delete;
  virtual ~ExecutionState() = default;

  virtual std::string_view name() const = 0;

  /// Once after all inputs of a moment. Returns the state that takes over at
  /// once; nullptr: it stays.
  virtual std::unique_ptr<ExecutionState> Step(ExecutionContext& context,
                                               Instant now, Decisions& out) = 0;

  virtual void OnSkillEnd(const EndedSkill&) {}

  /// What is reported unless the person is asked something.
  virtual ExecutionStatus Status(const ExecutionContext& context) const {
    return {.action = context.dispatch.ShowRunning(context.plan.rules())};
  }
};

using NextState = std::unique_ptr<ExecutionState>;

/// What has to come before anything is decided: Await unless an arm may begin
/// something, Sense unless the state is fresh; nullptr: nothing.
NextState Prerequisite(ExecutionContext& context, Instant now, Decisions& out);

/// The same, and for a state that waits: AwaitPerson if the person is at work,
/// Act if there is another plan than for `waits_in`.
NextState PrerequisiteToWait(ExecutionContext& context, const State& waits_in,
                             Instant now, Decisions& out);

}  // namespace cell::planner
