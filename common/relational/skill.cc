#include "common/relational/skill.h"

namespace cell {
namespace {

int ObjectOf(const Term& term, const Binding& binding) {
  return term.kind == Term::Kind::kObject ? term.index : binding.at(term.index);
}

}  // namespace

SkillBinding SkillBinding::FromConfig(const Config& config,
                                      const Vocabulary& vocabulary,
                                      std::span<const Variable> variables) {
  const auto term = [&](const Config& entry) {
    const Term read =
        ParseTerm(entry, TypeHierarchy::kObject, vocabulary, variables);
    if (read.kind == Term::Kind::kAny) entry.Fail("must be one object");
    return read;
  };
  SkillBinding skill;
  skill.name = config.Get<std::string>("name");
  skill.arm = term(config["arm"]);
  for (const auto& [key, entry] : config.Entries()) {
    if (key == "name" || key == "arm") continue;
    skill.arguments.emplace(key, term(entry));
  }
  return skill;
}

GroundSkill Bind(const SkillBinding& skill, const Binding& binding) {
  GroundSkill ground{skill.name, {}, ObjectOf(skill.arm, binding)};
  for (const auto& [name, term] : skill.arguments) {
    ground.arguments.emplace(name, ObjectOf(term, binding));
  }
  return ground;
}

}  // namespace cell
