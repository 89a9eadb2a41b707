#include "common/relational/rule.h"

#include <algorithm>

#include "common/relational/reference_binding.h"

namespace cell {
namespace {

/// The one object that the reference may stand for; nullopt if there is none,
/// or a second.
std::optional<int> ObjectOf(const DeicticReference& reference, Binding binding,
                            const State& state, const Vocabulary& vocabulary) {
  std::optional<int> found;
  binding.push_back(0);
  for (const int object : vocabulary.ObjectsOf(reference.variable.type)) {
    binding.back() = object;
    if (!MayHold(reference.literals, binding, state, vocabulary)) continue;
    if (found) return std::nullopt;
    found = object;
  }
  return found;
}

void BindEach(const Effect& effect, size_t next, Binding& binding,
              const Vocabulary& vocabulary,
              const std::function<void(const Effect&, const Binding&)>& visit) {
  if (next == effect.each.size()) return visit(effect, binding);
  binding.push_back(0);
  for (const int object : vocabulary.ObjectsOf(effect.each[next].type)) {
    binding.back() = object;
    BindEach(effect, next + 1, binding, vocabulary, visit);
  }
  binding.pop_back();
}

}  // namespace

bool NdrRule::IsFor(Agent agent) const {
  return std::find(agents.begin(), agents.end(), agent) != agents.end();
}

bool Action::MayBeDoneBy(Agent agent) const {
  return std::find(agents.begin(), agents.end(), agent) != agents.end();
}

bool Action::TakesArgumentsOf(const Action& other) const {
  return std::ranges::equal(arguments, other.arguments, {}, &Variable::type,
                            &Variable::type);
}

std::optional<size_t> BindReferences(const NdrRule& rule, const State& state,
                                     const Vocabulary& vocabulary,
                                     Binding* binding) {
  for (size_t i = 0; i < rule.references.size(); ++i) {
    const auto object =
        ObjectOf(rule.references[i], *binding, state, vocabulary);
    if (!object) return i;
    binding->push_back(*object);
  }
  return std::nullopt;
}

std::vector<ApplicableRule> ApplicableRules(const Action& action,
                                            const Binding& arguments,
                                            const State& state,
                                            const Vocabulary& vocabulary,
                                            Agent agent) {
  std::vector<ApplicableRule> applicable;
  for (size_t i = 0; i < action.rules.size(); ++i) {
    const NdrRule& rule = action.rules[i];
    if (!rule.IsFor(agent)) continue;
    Binding binding = arguments;
    if (!BindReferences(rule, state, vocabulary, &binding) &&
        MayHold(rule.context, binding, state, vocabulary)) {
      applicable.push_back({static_cast<int>(i), std::move(binding)});
    }
  }
  return applicable;
}

State Apply(const Outcome& outcome, const Binding& binding, const State& before,
            const Vocabulary& vocabulary) {
  State after = before;
  ForEachEffect(
      outcome, binding, vocabulary,
      [&](const Effect& effect, const Binding& bound) {
        if (!MayHold(effect.where, bound, before, vocabulary)) return;
        for (const Literal& literal : effect.then) {
          for (const int atom : Groundings(literal, bound, vocabulary)) {
            after.Set(atom, literal.is_negated ? Truth::kFalse : Truth::kTrue);
          }
        }
      });
  return after;
}

void ForEachEffect(
    const Outcome& outcome, const Binding& binding,
    const Vocabulary& vocabulary,
    const std::function<void(const Effect&, const Binding&)>& visit) {
  Binding bound = binding;
  for (const Effect& effect : outcome.effects) {
    BindEach(effect, 0, bound, vocabulary, visit);
  }
}

}  // namespace cell
