#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/robot_arm/skills/skill.h"

namespace cell::robot_arm {

std::unique_ptr<Skill> MakeInsert();
std::unique_ptr<Skill> MakePresent();
std::unique_ptr<Skill> MakePutDown();
std::unique_ptr<Skill> MakeFetch();
std::unique_ptr<Skill> MakeGoHome();
std::unique_ptr<Skill> MakeGoFree();

/// All skills that there are.
const std::vector<std::unique_ptr<Skill>>& AllSkills();
/// Those that an arm has, with or without a force-torque sensor.
std::vector<const Skill*> SkillsOf(bool has_force_sensor);
/// Nothing if the arm has the skill that is asked for, and the request has just
/// its arguments; else why not and what would be right.
std::optional<std::string> WhyNoSkill(const SkillRequest& request,
                                      bool has_force_sensor);
/// nullptr if there is none of that name.
const Skill* FindSkill(const std::string& name);

}  // namespace cell::robot_arm
