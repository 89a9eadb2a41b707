#pragma once

#include <memory>
#include <string_view>

#include "services/planner/execution/execution_context.h"

namespace cell::planner {

/// A state of the robot's execution. Each is a file of this folder.
///
///     a goal
///       |
///       v       arms at rest         one may begin         fresh state
///     AwaitRest ------------> Await ---------------> Sense -----------> Act
///
///     Act --goal reached--> CleanUp --arms are home--> Done
///     Act --a step is left to the person--> Ask
///     Act --no sure plan--> Undecided --patience is over--> Ask
///     Undecided --patience is over, something can be done meanwhile--> Act
///     Undecided, Ask --another plan, or other rules--> Act
///     Undecided, Ask, Act --the state changes after a question--> AwaitPerson
///     AwaitPerson --the state stays--> Act
///     Sense, Act, Undecided, Ask, AwaitPerson --no arm may begin--> Await
///     Act, Undecided, Ask, AwaitPerson --the state is not fresh--> Sense
///     all --another goal--> AwaitRest
///
/// The state is stale after a skill ends, and after a person that was asked has
/// put something down.
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
