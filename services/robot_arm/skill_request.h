#pragma once

#include <cstdint>
#include <string>

#include "common/skills/skill_arguments.h"

namespace cell::robot_arm {

/// What an arm is asked to do once: a skill by its name, with named arguments.
struct SkillRequest {
  int64_t id = 0;
  std::string skill;
  SkillArguments arguments;
  bool is_careful = false;  ///< at half speed

  /// Empty if it has none of that name.
  std::string Argument(const std::string& name) const {
    const auto it = arguments.find(name);
    return it == arguments.end() ? "" : it->second;
  }
};

struct SkillResult {
  enum class Outcome : int8_t {
    kSucceeded = 0,
    kRefused = 1,  ///< nothing has moved
    kFailed = 2,
    kStopped = 3,  ///< by a protective stop
    kYielded = 4   ///< to a person: it may be asked again
  };
  int64_t id = 0;
  Outcome outcome = Outcome::kSucceeded;
  std::string reason;     ///< why not, in plain words
  double peak_force = 0;  ///< [N]
};

}  // namespace cell::robot_arm
