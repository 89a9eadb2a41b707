#include "common/relational/rule_gap.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/relational/reference_binding.h"

namespace cell {
namespace {

bool IsBound(const Literal& literal, const Binding& binding) {
  return std::ranges::all_of(literal.terms, [&](const Term& term) {
    return term.kind != Term::Kind::kVariable ||
           static_cast<size_t>(term.index) < binding.size();
  });
}

RuleGap GapOf(const NdrRule& rule, Binding binding, const State& state,
              const Vocabulary& vocabulary) {
  RuleGap gap;
  gap.reference = BindReferences(rule, state, vocabulary, &binding);
  for (const Literal& literal : rule.context) {
    if (IsBound(literal, binding) &&
        !MayHold(literal, binding, state, vocabulary)) {
      gap.literals.push_back(literal);
    }
  }
  gap.binding = std::move(binding);
  return gap;
}

}  // namespace

std::vector<RuleGap> GapsOf(const RuleSet& rules, const GroundAction& action,
                            const State& state, Agent agent) {
  const Action& lifted = rules.ActionOf(action);
  std::vector<RuleGap> gaps;
  for (size_t i = 0; i < lifted.rules.size(); ++i) {
    if (!lifted.rules[i].IsFor(agent)) continue;
    gaps.push_back(
        GapOf(lifted.rules[i], action.arguments, state, rules.vocabulary()));
    gaps.back().rule = static_cast<int>(i);
  }
  return gaps;
}

std::vector<std::string> ShowGap(const RuleSet& rules,
                                 const GroundAction& action,
                                 const RuleGap& gap) {
  const Action& lifted = rules.ActionOf(action);
  const Vocabulary& vocabulary = rules.vocabulary();
  std::vector<std::string> texts;
  if (gap.reference) {
    const NdrRule& rule = lifted.rules.at(static_cast<size_t>(gap.rule));
    const DeicticReference& reference = rule.references.at(*gap.reference);
    std::vector<Variable> variables;
    for (const int object : gap.binding) {
      variables.push_back({vocabulary.objects()[object].name, 0});
    }
    variables.push_back(reference.variable);
    std::vector<std::string> literals;
    for (const Literal& literal : reference.literals) {
      literals.push_back(ToText(literal, vocabulary, variables));
    }
    texts.push_back(fmt::format("exactly one {} with {}",
                                reference.variable.name,
                                fmt::join(literals, ", ")));
  }
  for (const Literal& literal : gap.literals) {
    texts.push_back(Show(literal, gap.binding, vocabulary));
  }
  return texts;
}

}  // namespace cell
