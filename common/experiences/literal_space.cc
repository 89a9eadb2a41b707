#include "common/experiences/literal_space.h"

#include <algorithm>

namespace cell {

void ForEachLiteral(const std::vector<rules::Term>& terms,
                    const rules::World& world,
                    const std::function<void(const rules::Literal&)>& visit) {
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const rules::Symbol& symbol = world.symbols().all()[s];
    if (!symbol.is_primitive_predicate()) continue;
    size_t number = 1;
    for (int i = 0; i < symbol.arity; ++i) number *= terms.size();
    for (size_t code = 0; code < number; ++code) {
      rules::Literal literal;
      literal.symbol = static_cast<int>(s);
      size_t rest = code;
      for (int i = 0; i < symbol.arity; ++i) {
        literal.terms.push_back(terms[rest % terms.size()]);
        rest /= terms.size();
      }
      for (const auto truth :
           {rules::Comparison::kTrue, rules::Comparison::kFalse}) {
        literal.comparison = truth;
        visit(literal);
      }
    }
  }
}

std::vector<rules::Term> ArgumentTerms(const rules::Rule& rule) {
  std::vector<rules::Term> terms;
  for (size_t i = 0; i < rule.arguments.size(); ++i) {
    terms.push_back({rules::Term::Kind::kVariable, static_cast<int>(i)});
  }
  return terms;
}

bool NamesVariable(const rules::Literal& literal) {
  return std::ranges::any_of(literal.terms, [](const rules::Term& term) {
    return term.kind == rules::Term::Kind::kVariable;
  });
}

bool NamesNothing(const rules::Literal& literal) {
  return std::ranges::all_of(literal.terms, [](const rules::Term& term) {
    return term.kind == rules::Term::Kind::kAny;
  });
}

}  // namespace cell
