#include "common/actions/action_model.h"

namespace cell {

std::string SettingsOf(const SkillBinding& skill) {
  return skill.name == "insert" ? "insertion" : "motion";
}

}  // namespace cell
