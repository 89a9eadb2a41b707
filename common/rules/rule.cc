#include "common/rules/rule.h"

#include <algorithm>

namespace cell::rules {
namespace {

int ObjectOf(const Term& term, std::span<const int> binding) {
  return term.kind == Term::Kind::kObject
             ? term.index
             : binding[static_cast<size_t>(term.index)];
}

bool AreAllPresent(const WorldState& state) {
  for (const uint8_t is_present : state.is_present) {
    if (is_present == 0) return false;
  }
  return true;
}

/// True if one of the `number` atoms from `first` on is.
bool IsAnyTrue(const WorldState& state, int first, int number) {
  const int end = first + number;
  for (int place = first; place < end;) {
    const int in_word = std::min(64 - place % 64, end - place);
    uint64_t word = state.bits[static_cast<size_t>(place) / 64] >> (place % 64);
    if (in_word < 64) word &= (uint64_t{1} << in_word) - 1;
    if (word != 0) return true;
    place += in_word;
  }
  return false;
}

/// True if the atom is true for some objects in place of each `_`.
bool IsSomeTrue(const Literal& literal, std::span<const int> binding,
                const WorldState& state, const World& world, size_t next,
                int offset) {
  const int n = world.num_objects();
  if (next == literal.terms.size()) {
    return World::Get(state, world.first(literal.symbol) + offset);
  }
  const Term& term = literal.terms[next];
  if (term.kind != Term::Kind::kAny) {
    return IsSomeTrue(literal, binding, state, world, next + 1,
                      offset * n + ObjectOf(term, binding));
  }
  if (next + 1 == literal.terms.size() && AreAllPresent(state)) {
    return IsAnyTrue(state, world.first(literal.symbol) + offset * n, n);
  }
  for (int object = 0; object < n; ++object) {
    if (!state.is_present[static_cast<size_t>(object)]) continue;
    if (IsSomeTrue(literal, binding, state, world, next + 1,
                   offset * n + object)) {
      return true;
    }
  }
  return false;
}

/// The place of a literal without `_`.
int PlaceOfLiteral(const Literal& literal, std::span<const int> binding,
                   const World& world) {
  int offset = 0;
  for (const Term& term : literal.terms) {
    offset = offset * world.num_objects() + ObjectOf(term, binding);
  }
  return world.first(literal.symbol) + offset;
}

std::optional<int> UniqueObject(const Reference& reference,
                                std::vector<int> binding,
                                const WorldState& state, const World& world) {
  std::optional<int> found;
  binding.push_back(0);
  for (int object = 0; object < world.num_objects(); ++object) {
    if (!state.is_present[static_cast<size_t>(object)]) continue;
    binding.back() = object;
    const bool is_it =
        std::ranges::all_of(reference.literals, [&](const Literal& literal) {
          return Holds(literal, binding, state, world);
        });
    if (!is_it) continue;
    if (found) return std::nullopt;
    found = object;
  }
  return found;
}

void Change(const Literal& change, std::span<const int> binding,
            const World& world, WorldState* state) {
  const int place = PlaceOfLiteral(change, binding, world);
  if (world.symbols()[change.symbol].is_integer) {
    state->values[static_cast<size_t>(place)] = change.value;
  } else {
    World::Set(state, place, change.comparison == Comparison::kTrue);
  }
}

void ChangeEach(const QuantifiedChange& each, std::vector<int> binding,
                const WorldState& before, const World& world,
                WorldState* after) {
  binding.push_back(0);
  for (int object = 0; object < world.num_objects(); ++object) {
    if (!before.is_present[static_cast<size_t>(object)]) continue;
    binding.back() = object;
    const bool is_meant =
        std::ranges::all_of(each.where, [&](const Literal& literal) {
          return Holds(literal, binding, before, world);
        });
    if (is_meant) Change(each.change, binding, world, after);
  }
}

void AddActs(const World& world, const WorldState& state, GroundAct* act,
             std::vector<GroundAct>* acts) {
  const Symbol& symbol = world.symbols()[act->action];
  const Definition& condition = symbol.definition;
  if (static_cast<int>(act->arguments.size()) == symbol.arity) {
    for (const Definition::Atom& atom : condition.atoms) {
      std::vector<int> objects;
      for (const int v : atom.variables) {
        objects.push_back(act->arguments.at(static_cast<size_t>(v)));
      }
      if (World::Get(state, world.PlaceOf(atom.symbol, objects)) ==
          atom.is_negated) {
        return;
      }
    }
    acts->push_back(*act);
    return;
  }
  act->arguments.push_back(0);
  for (int object = 0; object < world.num_objects(); ++object) {
    if (!state.is_present[static_cast<size_t>(object)]) continue;
    act->arguments.back() = object;
    AddActs(world, state, act, acts);
  }
  act->arguments.pop_back();
}

}  // namespace

bool Compare(Comparison comparison, int left, int right) {
  if (left == World::kNoValue) return false;
  switch (comparison) {
    case Comparison::kEqual:
      return left == right;
    case Comparison::kNotEqual:
      return left != right;
    case Comparison::kAtMost:
      return left <= right;
    case Comparison::kAtLeast:
      return left >= right;
    case Comparison::kTrue:
    case Comparison::kFalse:
      break;
  }
  return false;
}

Comparison Opposite(Comparison comparison, int* value) {
  switch (comparison) {
    case Comparison::kTrue:
      return Comparison::kFalse;
    case Comparison::kFalse:
      return Comparison::kTrue;
    case Comparison::kEqual:
      return Comparison::kNotEqual;
    case Comparison::kNotEqual:
      return Comparison::kEqual;
    case Comparison::kAtMost:
      ++*value;
      return Comparison::kAtLeast;
    case Comparison::kAtLeast:
      --*value;
      return Comparison::kAtMost;
  }
  return comparison;
}

std::string Rule::VariableName(int index) const {
  const auto i = static_cast<size_t>(index);
  return i < arguments.size() ? arguments[i]
                              : references.at(i - arguments.size()).variable;
}

int Rule::num_literals() const {
  size_t number = context.size();
  for (const Reference& reference : references) {
    number += reference.literals.size();
  }
  for (const Outcome& outcome : outcomes) {
    number += outcome.changes.size();
    for (const QuantifiedChange& each : outcome.each) {
      number += each.where.size() + 1;
    }
  }
  return static_cast<int>(number);
}

Rule Rule::WithVariable(const std::string& variable) const {
  Rule rule = *this;
  rule.references.push_back({variable, {}});
  return rule;
}

bool Holds(const Literal& literal, std::span<const int> binding,
           const WorldState& state, const World& world) {
  if (literal.symbol == Literal::kSame) {
    return (ObjectOf(literal.terms[0], binding) ==
            ObjectOf(literal.terms[1], binding)) ==
           (literal.comparison == Comparison::kTrue);
  }
  if (world.symbols()[literal.symbol].is_integer) {
    const int place = PlaceOfLiteral(literal, binding, world);
    return Compare(literal.comparison, state.values[static_cast<size_t>(place)],
                   literal.value);
  }
  return IsSomeTrue(literal, binding, state, world, 0, 0) ==
         (literal.comparison == Comparison::kTrue);
}

std::optional<std::vector<int>> Bind(const Rule& rule,
                                     std::span<const int> arguments,
                                     const WorldState& state,
                                     const World& world) {
  std::vector<int> binding(arguments.begin(), arguments.end());
  for (const Reference& reference : rule.references) {
    const auto object = UniqueObject(reference, binding, state, world);
    if (!object) return std::nullopt;
    binding.push_back(*object);
  }
  for (const Literal& literal : rule.context) {
    if (!Holds(literal, binding, state, world)) return std::nullopt;
  }
  return binding;
}

std::optional<Coverage> FindCoverage(const NdrRules& rules,
                                     const GroundAct& act,
                                     const WorldState& state,
                                     const World& world) {
  std::optional<Coverage> found;
  for (const Rule& rule : rules.rules) {
    if (rule.action != act.action) continue;
    auto binding = Bind(rule, act.arguments, state, world);
    if (!binding) continue;
    if (found) return std::nullopt;
    found = Coverage{&rule, std::move(*binding)};
  }
  return found;
}

WorldState Apply(const Outcome& outcome, std::span<const int> binding,
                 const WorldState& before, const World& world) {
  WorldState after = before;
  for (const QuantifiedChange& each : outcome.each) {
    ChangeEach(each, {binding.begin(), binding.end()}, before, world, &after);
  }
  for (const Literal& change : outcome.changes) {
    Change(change, binding, world, &after);
  }
  world.Derive(&after);
  return after;
}

std::vector<GroundAct> GroundActs(const World& world, const WorldState& state) {
  std::vector<GroundAct> acts;
  for (const int action : world.symbols().Actions()) {
    GroundAct act{action, {}};
    AddActs(world, state, &act, &acts);
  }
  return acts;
}

}  // namespace cell::rules
