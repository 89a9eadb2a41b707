#include "services/planner/demonstrations.h"

#include <iterator>
#include <utility>

namespace cell::planner {

void Demonstrations::Clear() {
  states_.clear();
  waiting_.clear();
}

void Demonstrations::Update(const SensedState& sensed) {
  states_.emplace(sensed.key_frame, sensed.state);
  if (states_.size() > kMaxRemembered) states_.erase(states_.begin());
}

void Demonstrations::Update(const ShownAction& shown) {
  waiting_.push_back(shown);
  if (waiting_.size() > kMaxRemembered) waiting_.pop_front();
}

std::vector<TaskExperience> Demonstrations::Take() {
  std::vector<TaskExperience> experiences;
  std::erase_if(waiting_, [&](const ShownAction& shown) {
    auto experience = Of(shown);
    if (!experience) return false;
    experiences.push_back(*std::move(experience));
    return true;
  });
  return experiences;
}

std::optional<TaskExperience> Demonstrations::Of(
    const ShownAction& shown) const {
  const auto after = states_.find(shown.place_key_frame);
  const auto next = states_.lower_bound(shown.pick_key_frame);
  if (after == states_.end() || next == states_.begin()) return std::nullopt;
  TaskExperience experience{shown.action, shown.objects, Agent::kPerson,
                            std::prev(next)->second, after->second};
  if (shown.is_reversed) std::swap(experience.before, experience.after);
  return experience;
}

}  // namespace cell::planner
