#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/planner/monitor.h"

namespace cell::planner {

/// A moment of the run.
struct Instant {
  int64_t utime = 0;  ///< [us]
  int32_t tick = 0;
};

/// What an arm is to do once. Objects are the vocabulary's.
struct ArmOrder {
  enum class Kind { kInsert, kPresent, kPutDown, kGoHome, kGoFree };
  int64_t id = 0;              ///< unique in a run, across lives of the planner
  int64_t deadline_utime = 0;  ///< [us] not begun later
  int arm = 0;
  Kind kind = Kind::kInsert;
  std::optional<int> part;  ///< nothing for kGoHome, kGoFree
  std::optional<int> site;  ///< of kInsert
};

struct ArmOutcome {
  enum class Outcome { kSucceeded, kRefused, kFailed, kStopped, kYielded };
  int64_t id = 0;
  int64_t utime = 0;  ///< [us] of the end
  int arm = 0;
  Outcome outcome = Outcome::kSucceeded;
  std::string reason;
};

/// How far the robot is.
struct Execution {
  enum class State { kRunning, kDone, kStuck };
  State state = State::kRunning;
  std::string action;        ///< being done; empty: none
  std::string text;          ///< kStuck: the question to the person
  std::vector<Wish> needed;  ///< kStuck: what would have to be otherwise
  /// kStuck: the step that is left to a person.
  std::optional<GroundAction> step = {};
  bool operator==(const Execution&) const = default;
};

/// What is to be said at a moment.
struct Orders {
  std::vector<ArmOrder> requests;            ///< at most one for each arm
  bool sense = false;                        ///< ask for the predicates
  std::optional<Execution> execution;        ///< if it has changed
  std::optional<Monitor::PlanOfState> plan;  ///< if it has changed
};

}  // namespace cell::planner
