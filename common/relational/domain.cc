#include "common/relational/domain.h"

#include <algorithm>

#include "common/relational/ground_action.h"

namespace cell {

bool Domain::Put(const Action& action) {
  const std::optional<int> known = FindAction(action.name);
  if (!known) {
    actions_.push_back(action);
    return true;
  }
  Action& kept = actions_[static_cast<size_t>(*known)];
  if (kept == action) return false;
  kept = action;
  return true;
}

std::optional<int> Domain::FindAction(const std::string& name) const {
  return cell::FindAction(actions_, name);
}

const Goal* Domain::FindGoal(const std::string& name) const {
  const auto it = std::find_if(goals_.begin(), goals_.end(),
                               [&](const Goal& g) { return g.name == name; });
  return it == goals_.end() ? nullptr : &*it;
}

std::vector<GroundAction> Domain::GroundActions(Agent agent) const {
  return cell::GroundActions(actions_, vocabulary_, agent);
}

std::optional<GroundAction> Domain::FindGroundAction(
    const std::string& name, const std::vector<std::string>& objects) const {
  return cell::FindGroundAction(actions_, vocabulary_, name, objects);
}

std::optional<GroundSkill> Domain::SkillOf(const GroundAction& action) const {
  const std::optional<SkillBinding>& skill = actions_.at(action.action).skill;
  if (!skill) return std::nullopt;
  return Bind(*skill, action.arguments);
}

std::string Domain::Show(const GroundAction& action) const {
  return vocabulary_.Show(actions_.at(action.action).name, action.arguments);
}

}  // namespace cell
