#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/robot_arm/skill_request.h"

namespace cell::robot_arm {

class Arm;
class SkillRun;

/// What others must know of a skill, without knowing which it is.
struct SkillTraits {
  bool needs_force_sensor = false;
  /// It may run while another arm is at work.
  bool may_run_beside = false;
  /// It brings the part to where another arm can take it.
  bool hands_over = false;
  /// After a failure the arm goes home, so that the others have room.
  bool leaves_room_after_failure = true;
};

/// Something that an arm can do when asked for it by name: why not, and by
/// which stages. One file each in this folder, entered in skill_catalog.cc.
class Skill {
 public:
  Skill() = default;
  Skill(const Skill&) = delete;
  Skill& operator=(const Skill&) = delete;
  virtual ~Skill() = default;

  virtual std::string name() const = 0;
  virtual SkillTraits traits() const { return {}; }
  /// The names that its arguments have; all are wanted.
  virtual std::vector<std::string> arguments() const { return {}; }
  /// Why the arm cannot begin it; nothing if it can. @pre the request has the
  /// arguments.
  virtual std::optional<std::string> WhyNot(const SkillRequest& request,
                                            const Arm& arm) const = 0;
  /// Adds its stages.
  virtual void Plan(SkillRun& run) const = 0;
};

}  // namespace cell::robot_arm
