#pragma once

#include <vector>

#include "common/relational/robot_addition.h"
#include "common/relational/skill.h"

namespace cell {

/// What an arm needs to begin a skill, one of these, and what the skill's
/// success changes of the arm. It belongs to the skill, whatever action the arm
/// does by it:
///
///   insert  the arm holds the part, which it then holds no longer; or it can
///           take the part, and holds nothing
///
/// Empty for other skills, whose rules say it themselves, and in a domain where
/// arms report nothing.
std::vector<RobotAddition> NeedsOf(const SkillBinding& skill,
                                   const Vocabulary& vocabulary);

/// The action with the needs of its skill: its rules for the robot that have no
/// condition on what arms report get them. A rule that has one says what the
/// robot needs itself; so the result is the same if this is done twice.
Action WithSkillNeeds(Action action, const Vocabulary& vocabulary);

}  // namespace cell
