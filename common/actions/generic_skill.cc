#include "common/actions/generic_skill.h"

namespace cell {

GenericSkill::GenericSkill(const Vocabulary& vocabulary,
                           std::span<const PredicateGeometry> geometries,
                           const CellLayout& layout)
    : seats_(vocabulary.predicates().size()) {
  for (size_t i = 0; i < geometries.size(); ++i) {
    const auto* seated = std::get_if<SeatedGeometry>(&geometries[i]);
    if (seated == nullptr) continue;
    if (!seated->site) {
      seats_[i] = Seat{.is_second_argument = true};
    } else if (const auto site = vocabulary.FindObject(seated->site->name)) {
      seats_[i] = Seat{.site = *site};
    }
  }
  for (const ArmLayout& arm : layout.arms) {
    if (arm.X_FS && !arm_) arm_ = vocabulary.FindObject(arm.name);
  }
}

std::optional<SkillBinding> GenericSkill::For(const LearnedModel& model) const {
  if (!arm_) return std::nullopt;
  const Term moved{Term::Kind::kVariable, static_cast<int>(model.moved)};
  for (const Literal& before : ChangedLiterals(model.pick, model.place)) {
    if (before.is_static || !before.is_negated || before.terms[0] != moved) {
      continue;
    }
    const auto& seat = seats_[static_cast<size_t>(before.relation)];
    if (!seat) continue;
    return SkillBinding{"insert",
                        {{"part", moved},
                         {"site", seat->is_second_argument
                                      ? before.terms[1]
                                      : Term{Term::Kind::kObject, seat->site}}},
                        {Term::Kind::kObject, *arm_}};
  }
  return std::nullopt;
}

}  // namespace cell
