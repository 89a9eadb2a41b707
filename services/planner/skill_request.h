#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/relational/rule_set.h"

namespace cell::planner {

/// What an arm is to do once. Objects are the vocabulary's.
struct SkillRequest {
  /// What the planner wants it for.
  enum class Purpose { kAction, kCleanUp, kGoFree };
  int64_t id = 0;  ///< unique in a run, across starts of the planner
  int64_t deadline_utime = 0;  ///< [us] not begun later
  int arm = 0;
  Purpose purpose = Purpose::kAction;
  std::string skill = {};                     ///< one that the arm reports
  std::map<std::string, int> arguments = {};  ///< objects by name
  bool is_careful = false;                    ///< at half speed
};

/// How a skill ended.
struct SkillResult {
  enum class Outcome { kSucceeded, kRefused, kFailed, kStopped, kYielded };
  int64_t id = 0;
  int64_t utime = 0;  ///< [us] of the end
  int arm = 0;
  Outcome outcome = Outcome::kSucceeded;
  std::string reason;
};

/// The one place where a planned action becomes a request, still without id
/// and deadline; nullopt if no arm can do the action.
std::optional<SkillRequest> RequestFor(const GroundAction& action,
                                       const RuleSet& rules);

/// True if both have an object as an argument.
bool ShareAnObject(const SkillRequest& a, const SkillRequest& b);

/// What an arm does when the goal is reached: it puts down what it holds, and
/// with an empty hand goes home.
SkillRequest RequestToCleanUp(int arm, std::optional<int> held);

/// Lets go of what a site holds, and draws back.
SkillRequest RequestToGoFree(int arm);

}  // namespace cell::planner
