#include "services/recognizer/generic_skill.h"

#include <variant>

namespace cell::recognizer {
namespace {

bool IsRole(const Term& term, size_t role) {
  return term.kind == Term::Kind::kVariable &&
         term.index == static_cast<int>(role);
}

}  // namespace

GenericSkill::GenericSkill(const Vocabulary& vocabulary,
                           std::span<const PredicateGeometry> geometries,
                           int arm)
    : arm_{Term::Kind::kObject, arm} {
  for (const PredicateGeometry& geometry : geometries) {
    auto& of_predicate = seated_.emplace_back();
    const auto* seated = std::get_if<SeatedGeometry>(&geometry);
    if (seated == nullptr) continue;
    of_predicate.emplace();
    if (!seated->site) continue;
    of_predicate->site = vocabulary.FindObject(seated->site->name);
    if (!of_predicate->site) of_predicate.reset();
  }
}

std::optional<Term> GenericSkill::SiteOf(const Literal& literal,
                                         size_t moved) const {
  if (literal.is_static || literal.is_negated ||
      !IsRole(literal.terms.at(0), moved)) {
    return std::nullopt;
  }
  const auto& seated = seated_.at(static_cast<size_t>(literal.relation));
  if (!seated) return std::nullopt;
  if (!seated->site) return literal.terms.at(1);
  return Term{Term::Kind::kObject, *seated->site};
}

std::optional<SkillBinding> GenericSkill::For(const LearnedModel& model) const {
  for (const Literal& before : ChangedLiterals(model.pick, model.place)) {
    const auto site = SiteOf(Negated(before), model.moved);
    if (!site) continue;
    const Term part{Term::Kind::kVariable, static_cast<int>(model.moved)};
    return SkillBinding{"insert", {{"part", part}, {"site", *site}}, arm_};
  }
  return std::nullopt;
}

std::optional<int> GenericSkill::ArmThatInserts(std::span<const ArmLayout> arms,
                                                const Vocabulary& vocabulary) {
  const ArmLayout* inserting = nullptr;
  for (const ArmLayout& arm : arms) {
    if (!arm.X_FS || !vocabulary.FindObject(arm.name)) continue;
    if (inserting == nullptr || arm.precedence < inserting->precedence) {
      inserting = &arm;
    }
  }
  if (inserting == nullptr) return std::nullopt;
  return vocabulary.FindObject(inserting->name);
}

}  // namespace cell::recognizer
