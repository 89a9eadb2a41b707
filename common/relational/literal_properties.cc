#include "common/relational/literal_properties.h"

#include <algorithm>

namespace cell {
namespace {

bool MayBe(const Term& term, std::span<const Variable> variables,
           const Term& ground, const Vocabulary& vocabulary) {
  if (term.kind == Term::Kind::kAny || ground.kind != Term::Kind::kObject) {
    return true;
  }
  if (term.kind == Term::Kind::kObject) return term.index == ground.index;
  return vocabulary.IsOf(ground.index,
                         variables[static_cast<size_t>(term.index)].type);
}

}  // namespace

bool NamesVariable(const Literal& literal) {
  return std::ranges::any_of(literal.terms, [](const Term& term) {
    return term.kind == Term::Kind::kVariable;
  });
}

bool IsReported(const Literal& literal, const Vocabulary& vocabulary) {
  return !literal.is_static &&
         vocabulary.predicates()[static_cast<size_t>(literal.relation)]
             .report.has_value();
}

bool MayBe(const Literal& literal, std::span<const Variable> variables,
           const Literal& ground, const Vocabulary& vocabulary) {
  if (literal.is_static != ground.is_static ||
      literal.relation != ground.relation ||
      literal.is_negated != ground.is_negated) {
    return false;
  }
  for (size_t i = 0; i < ground.terms.size(); ++i) {
    if (!MayBe(literal.terms[i], variables, ground.terms[i], vocabulary)) {
      return false;
    }
  }
  return true;
}

}  // namespace cell
