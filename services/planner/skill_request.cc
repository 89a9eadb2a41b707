#include "services/planner/skill_request.h"

#include <algorithm>

namespace cell::planner {

std::optional<SkillRequest> RequestFor(const GroundAction& action,
                                       const RuleSet& rules) {
  const std::optional<GroundSkill> skill = rules.SkillOf(action);
  if (!skill) return std::nullopt;
  return SkillRequest{
      .arm = skill->arm, .skill = skill->name, .arguments = skill->arguments};
}

bool ShareAnObject(const SkillRequest& a, const SkillRequest& b) {
  return std::ranges::any_of(a.arguments, [&](const auto& entry) {
    return std::ranges::any_of(b.arguments, [&](const auto& other) {
      return other.second == entry.second;
    });
  });
}

SkillRequest RequestToCleanUp(int arm, std::optional<int> held) {
  SkillRequest request{.arm = arm, .purpose = SkillRequest::Purpose::kCleanUp};
  request.skill = held ? "put_down" : "go_home";
  if (held) request.arguments["part"] = *held;
  return request;
}

SkillRequest RequestToGoFree(int arm) {
  return {.arm = arm,
          .purpose = SkillRequest::Purpose::kGoFree,
          .skill = "go_free"};
}

}  // namespace cell::planner
