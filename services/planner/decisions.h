#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/experiences/task_experience.h"
#include "services/planner/execution_status.h"
#include "services/planner/judgement.h"
#include "services/planner/plan.h"
#include "services/planner/skill_request.h"

namespace cell::planner {

/// A moment of the run.
struct Instant {
  int64_t utime = 0;  ///< [us]
  int32_t tick = 0;
};

/// What a person must know.
struct Alert {
  enum class Cause {
    kLongerPlan,
    kNoPlan,
    kUnexplained,  ///< a change that no recognised action accounts for
    kStuck,        ///< the robot asks
    kBadInput
  };
  Cause cause;
  int64_t utime = 0;  ///< [us] of the action, or of now
  std::string text;
  /// What it stands on, if it is about an action.
  std::shared_ptr<const Judgement> judgement = {};
};

/// What follows from an input or a moment: to be published, in this order.
struct Decisions {
  std::vector<SkillRequest> requests = {};        ///< at most one for each arm
  bool sense = false;                             ///< ask for the predicates
  std::optional<PlanOfState> plan = {};           ///< if there is one to report
  std::optional<ExecutionStatus> execution = {};  ///< if it has changed
  std::vector<Alert> alerts = {};
  std::vector<TaskExperience> experiences = {};  ///< to be kept
};

}  // namespace cell::planner
