#include "common/sec/stand_ins.h"

#include <algorithm>

namespace cell {
namespace {

std::set<int> ChangedPredicates(const LearnedModel& model) {
  std::set<int> predicates;
  for (const Literal& literal : model.RequiredLiterals()) {
    predicates.insert(literal.relation);
  }
  return predicates;
}

/// The literal's predicate takes the object in the role.
bool CanBeSaid(const Literal& literal, size_t role, int object,
               const Vocabulary& vocabulary) {
  const auto& types =
      vocabulary.predicates()[static_cast<size_t>(literal.relation)]
          .argument_types;
  for (size_t i = 0; i < literal.terms.size(); ++i) {
    const Term& term = literal.terms[i];
    if (term.kind == Term::Kind::kVariable &&
        static_cast<size_t>(term.index) == role &&
        !vocabulary.IsOf(object, types[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::set<int> StandIns(const LearnedModel& model,
                       std::span<const LearnedModel> all,
                       const Vocabulary& vocabulary) {
  const LiteralSet required = model.RequiredLiterals();
  const std::set<int> changed = ChangedPredicates(model);
  std::set<int> stand_ins;
  if (changed.empty()) return stand_ins;
  for (const int object : vocabulary.ObjectsOf(TypeHierarchy::kObject)) {
    const bool has_action =
        std::ranges::any_of(all, [&](const LearnedModel& other) {
          return vocabulary.IsOf(object, other.roles[other.moved].type) &&
                 ChangedPredicates(other) == changed;
        });
    if (!has_action && std::ranges::all_of(required, [&](const Literal& l) {
          return CanBeSaid(l, model.moved, object, vocabulary);
        })) {
      stand_ins.insert(object);
    }
  }
  return stand_ins;
}

}  // namespace cell
