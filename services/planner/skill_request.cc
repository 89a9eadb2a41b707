#include "services/planner/skill_request.h"

namespace cell::planner {
namespace {

SkillRequest::Kind KindOf(Skill::Kind kind) {
  switch (kind) {
    case Skill::Kind::kInsert:
      return SkillRequest::Kind::kInsert;
    case Skill::Kind::kPresent:
      return SkillRequest::Kind::kPresent;
    case Skill::Kind::kPutDown:
      return SkillRequest::Kind::kPutDown;
  }
  return SkillRequest::Kind::kPutDown;
}

}  // namespace

std::optional<SkillRequest> RequestFor(const GroundAction& action,
                                       const RuleSet& rules) {
  const std::optional<GroundSkill> skill = rules.SkillOf(action);
  if (!skill) return std::nullopt;
  return SkillRequest{.arm = skill->arm,
                      .kind = KindOf(skill->kind),
                      .part = skill->part,
                      .site = skill->site};
}

bool MayRunBesideAnother(const SkillRequest& request) {
  return request.kind == SkillRequest::Kind::kPresent;
}

SkillRequest RequestToCleanUp(int arm, std::optional<int> held) {
  using enum SkillRequest::Kind;
  return {.arm = arm, .kind = held ? kPutDown : kGoHome, .part = held};
}

SkillRequest RequestToGoFree(int arm) {
  return {.arm = arm, .kind = SkillRequest::Kind::kGoFree};
}

}  // namespace cell::planner
