#include "common/actions/action_model.h"

namespace cell {

std::string SettingsOf(const Skill& skill) {
  return skill.kind == Skill::Kind::kInsert ? "insertion" : "motion";
}

}  // namespace cell
