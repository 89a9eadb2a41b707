#include "common/relational/bound_rule.h"

#include <span>
#include <utility>

#include "common/relational/reference_binding.h"

namespace cell {
namespace {

std::span<const Literal> ContextWithoutReferences(const NdrRule& rule) {
  if (!rule.references.empty()) return {};
  return rule.context;
}

}  // namespace

BoundRule::BoundRule(const NdrRule& rule, Binding arguments,
                     const Vocabulary& vocabulary)
    : rule_(rule),
      arguments_(std::move(arguments)),
      vocabulary_(vocabulary),
      context_(ContextWithoutReferences(rule), arguments_, vocabulary) {
  if (!rule.references.empty() || !context_.is_possible()) return;
  for (const Outcome& outcome : rule.outcomes) {
    effects_.push_back(EffectsOf(outcome));
  }
}

std::vector<BoundRule::BoundEffect> BoundRule::EffectsOf(
    const Outcome& outcome) const {
  std::vector<BoundEffect> effects;
  ForEachEffect(
      outcome, arguments_, vocabulary_,
      [&](const Effect& effect, const Binding& binding) {
        BoundEffect bound{{effect.where, binding, vocabulary_}, {}};
        if (!bound.where.is_possible()) return;
        for (const Literal& literal : effect.then) {
          const Truth truth = literal.is_negated ? Truth::kFalse : Truth::kTrue;
          for (const int atom : Groundings(literal, binding, vocabulary_)) {
            bound.then.push_back({atom, truth});
          }
        }
        effects.push_back(std::move(bound));
      });
  return effects;
}

bool BoundRule::MayCover(const State& state) const {
  if (rule_.references.empty()) return context_.MayHold(state);
  Binding binding = arguments_;
  return !BindReferences(rule_, state, vocabulary_, &binding) &&
         MayHold(rule_.context, binding, state, vocabulary_);
}

State BoundRule::After(size_t outcome, const State& before) const {
  if (!rule_.references.empty()) {
    Binding binding = arguments_;
    BindReferences(rule_, before, vocabulary_, &binding);
    return Apply(rule_.outcomes[outcome], binding, before, vocabulary_);
  }
  State after = before;
  for (const BoundEffect& effect : effects_[outcome]) {
    if (!effect.where.MayHold(before)) continue;
    for (const auto& [atom, truth] : effect.then) after.Set(atom, truth);
  }
  return after;
}

}  // namespace cell
