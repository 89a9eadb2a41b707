#include "services/robot_arm/skills/skill_catalog.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cell::robot_arm {
namespace {

std::vector<std::unique_ptr<Skill>> MakeAll() {
  std::vector<std::unique_ptr<Skill>> skills;
  for (const auto& make : {MakeInsert, MakePresent, MakePutDown, MakeFetch,
                           MakeGoHome, MakeGoFree}) {
    skills.push_back(make());
  }
  return skills;
}

std::vector<std::string> NamesOf(const std::vector<const Skill*>& skills) {
  std::vector<std::string> names;
  for (const Skill* skill : skills) names.push_back(skill->name());
  return names;
}

}  // namespace

const std::vector<std::unique_ptr<Skill>>& AllSkills() {
  static const auto skills = MakeAll();
  return skills;
}

const Skill* FindSkill(const std::string& name) {
  for (const auto& skill : AllSkills()) {
    if (skill->name() == name) return skill.get();
  }
  return nullptr;
}

std::vector<const Skill*> SkillsOf(bool has_force_sensor) {
  std::vector<const Skill*> skills;
  for (const auto& skill : AllSkills()) {
    if (has_force_sensor || !skill->traits().needs_force_sensor) {
      skills.push_back(skill.get());
    }
  }
  return skills;
}

std::optional<std::string> WhyNoSkill(const SkillRequest& request,
                                      bool has_force_sensor) {
  const Skill* skill = FindSkill(request.skill);
  if (skill == nullptr) {
    return fmt::format("it has no skill '{}'; it has {}", request.skill,
                       fmt::join(NamesOf(SkillsOf(has_force_sensor)), ", "));
  }
  if (skill->traits().needs_force_sensor && !has_force_sensor) {
    return "it has no force-torque sensor, which " + request.skill + " needs";
  }
  std::vector<std::string> given;
  for (const auto& [name, value] : request.arguments) given.push_back(name);
  std::vector<std::string> wanted = skill->arguments();
  std::ranges::sort(wanted);
  if (given == wanted) return std::nullopt;
  return fmt::format("{} takes the arguments [{}], not [{}]", request.skill,
                     fmt::join(wanted, ", "), fmt::join(given, ", "));
}

}  // namespace cell::robot_arm
