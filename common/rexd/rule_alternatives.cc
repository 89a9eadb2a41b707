#include "common/rexd/rule_alternatives.h"

#include <algorithm>

namespace cell::rexd {

using namespace rules;
namespace {

/// All ways to choose the terms of a literal that is true in the state.
void AddTrueLiterals(const Rule& rule, const std::vector<int>& binding,
                     const WorldState& state, const World& world,
                     Literal* literal, std::vector<Literal>* all) {
  const auto arity =
      static_cast<size_t>(world.symbols()[literal->symbol].arity);
  if (literal->terms.size() == arity) {
    literal->comparison = Comparison::kTrue;
    if (!Holds(*literal, binding, state, world)) {
      literal->comparison = Comparison::kFalse;
    }
    const bool is_there =
        std::ranges::find(rule.context, *literal) != rule.context.end();
    if (!is_there) all->push_back(*literal);
    return;
  }
  const auto add_with = [&](const Term& term) {
    literal->terms.push_back(term);
    AddTrueLiterals(rule, binding, state, world, literal, all);
    literal->terms.pop_back();
  };
  for (int i = 0; i < rule.num_variables(); ++i) {
    add_with({Term::Kind::kVariable, i});
  }
  add_with({Term::Kind::kAny, 0});
}

/// Literals over the rule's variables, or of any object, that hold in the
/// state; what is true before what is not.
std::vector<Literal> TrueLiterals(const Rule& rule,
                                  const std::vector<int>& binding,
                                  const WorldState& state, const World& world) {
  std::vector<Literal> all;
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const Symbol& symbol = world.symbols()[static_cast<int>(s)];
    if (symbol.kind == Symbol::Kind::kAction || symbol.is_integer ||
        symbol.arity == 0) {
      continue;
    }
    Literal literal{static_cast<int>(s), {}, Comparison::kTrue, 0};
    AddTrueLiterals(rule, binding, state, world, &literal, &all);
  }
  std::ranges::stable_partition(all, [](const Literal& literal) {
    return literal.comparison == Comparison::kTrue;
  });
  return all;
}

bool CoversTheSame(const Rule& a, const Rule& b, const World& world,
                   const std::vector<Experience>& experiences) {
  return std::ranges::all_of(experiences, [&](const Experience& e) {
    return e.act.action != a.action ||
           Bind(a, e.act.arguments, e.before, world) ==
               Bind(b, e.act.arguments, e.before, world);
  });
}

/// The objects of the rule without its precondition.
std::optional<std::vector<int>> BindLoosely(Rule rule, const GroundAct& act,
                                            const WorldState& state,
                                            const World& world) {
  rule.context.clear();
  return Bind(rule, act.arguments, state, world);
}

}  // namespace

std::vector<NdrRules> RuleAlternatives(
    const NdrRules& rules, const World& world, const WorldState& state,
    const Guidance& guidance, const std::vector<Experience>& experiences) {
  std::vector<NdrRules> alternatives;
  for (const Guidance::BlockedAct& blocked : guidance.blocked_acts) {
    for (size_t r = 0; r < rules.rules.size(); ++r) {
      const Rule& rule = rules.rules[r];
      if (rule.action != blocked.act.action) continue;
      const auto binding = BindLoosely(rule, blocked.act, state, world);
      if (!binding) continue;
      for (size_t i = 0; i < rule.context.size(); ++i) {
        if (rule.context[i].symbol != blocked.needs.symbol ||
            Holds(rule.context[i], *binding, state, world)) {
          continue;
        }
        for (const Literal& other :
             TrueLiterals(rule, *binding, state, world)) {
          NdrRules changed = rules;
          changed.rules[r].context[i] = other;
          if (CoversTheSame(rule, changed.rules[r], world, experiences)) {
            alternatives.push_back(std::move(changed));
          }
        }
      }
    }
  }
  return alternatives;
}

}  // namespace cell::rexd
