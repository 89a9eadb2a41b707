#include "common/sec/stand_in_proposal.h"

#include <algorithm>

#include "common/sec/stand_ins.h"

namespace cell {
namespace {

/// The static relations of the model hold with these objects in its roles.
bool Fits(const LearnedModel& model, const Binding& objects,
          const Vocabulary& vocabulary) {
  const State nothing(vocabulary.num_atoms());
  return std::ranges::all_of(model.pick.where, [&](const Literal& literal) {
    return !literal.is_static || MayHold(literal, objects, nothing, vocabulary);
  });
}

/// What must not be so before the pick-up is not so, with whatever in the other
/// roles: a part that is placed somewhere else is in use.
bool IsUnused(const LearnedModel& model, const Binding& objects,
              const State& state, const Vocabulary& vocabulary) {
  return std::ranges::all_of(model.RequiredLiterals(), [&](Literal literal) {
    if (!literal.is_negated) return true;
    for (Term& term : literal.terms) {
      if (term.kind == Term::Kind::kVariable &&
          static_cast<size_t>(term.index) != model.moved) {
        term = {Term::Kind::kAny, 0};
      }
    }
    return MayHold(literal, objects, state, vocabulary);
  });
}

}  // namespace

std::vector<int> ProposeStandIns(const LearnedModel& model,
                                 std::span<const LearnedModel> all,
                                 const Binding& usual, const State& state,
                                 const Vocabulary& vocabulary) {
  std::vector<int> proposed;
  for (const int object : StandIns(model, all, vocabulary)) {
    Binding objects = usual;
    objects.at(model.moved) = object;
    if (object != usual[model.moved] && Fits(model, objects, vocabulary) &&
        IsUnused(model, objects, state, vocabulary)) {
      proposed.push_back(object);
    }
  }
  return proposed;
}

}  // namespace cell
