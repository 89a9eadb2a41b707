#include "common/relational/skill.h"

namespace cell {
namespace {

Skill::Kind KindFromConfig(const Config& config) {
  const auto name = config.As<std::string>();
  for (const auto kind :
       {Skill::Kind::kInsert, Skill::Kind::kPresent, Skill::Kind::kPutDown}) {
    if (name == NameOf(kind)) return kind;
  }
  config.Fail("'" + name + "' is none of insert, present, put_down");
}

int ObjectOf(const Term& term, const Binding& arguments) {
  return term.kind == Term::Kind::kObject ? term.index
                                          : arguments.at(term.index);
}

}  // namespace

Skill Skill::FromConfig(const Config& config, const Vocabulary& vocabulary,
                        std::span<const Variable> arguments) {
  const auto term = [&](const std::string& key) {
    const Term read =
        ParseTerm(config[key], TypeHierarchy::kObject, vocabulary, arguments);
    if (read.kind == Term::Kind::kAny) config[key].Fail("must be one object");
    return read;
  };
  Skill skill;
  skill.kind = KindFromConfig(config["kind"]);
  skill.part = term("part");
  skill.arm = term("arm");
  if (skill.kind == Kind::kInsert) {
    skill.site = term("site");
  } else if (config.Has("site")) {
    config["site"].Fail("only insert has a site");
  }
  return skill;
}

const char* NameOf(Skill::Kind kind) {
  switch (kind) {
    case Skill::Kind::kInsert:
      return "insert";
    case Skill::Kind::kPresent:
      return "present";
    case Skill::Kind::kPutDown:
      break;
  }
  return "put_down";
}

GroundSkill Bind(const Skill& skill, const Binding& arguments) {
  GroundSkill ground{skill.kind, ObjectOf(skill.part, arguments), std::nullopt,
                     ObjectOf(skill.arm, arguments)};
  if (skill.kind == Skill::Kind::kInsert) {
    ground.site = ObjectOf(skill.site, arguments);
  }
  return ground;
}

}  // namespace cell
