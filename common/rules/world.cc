#include "common/rules/world.h"

#include <algorithm>
#include <functional>

namespace cell::rules {
namespace {

/// Calls visit(objects) for all tuples of present objects.
void ForEachTuple(int arity, const WorldState& state,
                  const std::function<void(std::vector<int>&)>& visit,
                  std::vector<int>* tuple) {
  if (static_cast<int>(tuple->size()) == arity) return visit(*tuple);
  for (size_t object = 0; object < state.is_present.size(); ++object) {
    if (!state.is_present[object]) continue;
    tuple->push_back(static_cast<int>(object));
    ForEachTuple(arity, state, visit, tuple);
    tuple->pop_back();
  }
}

}  // namespace

World::World(std::shared_ptr<const SymbolTable> symbols,
             const std::vector<std::string>& objects)
    : symbols_(std::move(symbols)), objects_(symbols_->constants()) {
  for (const std::string& object : objects) {
    if (std::ranges::count(objects_, object) == 0) objects_.push_back(object);
  }
  powers_ = {1};
  for (int i = 0; i < kMaxArity; ++i) {
    powers_.push_back(powers_.back() * num_objects());
  }
  for (const Symbol& symbol : symbols_->all()) {
    int& next = symbol.is_integer ? num_values_ : num_bits_;
    first_.push_back(next);
    if (symbol.kind != Symbol::Kind::kAction) next += powers_[symbol.arity];
  }
}

std::optional<int> World::FindObject(const std::string& name) const {
  const auto it = std::ranges::find(objects_, name);
  if (it == objects_.end()) return std::nullopt;
  return static_cast<int>(it - objects_.begin());
}

WorldState World::EmptyState(bool are_present) const {
  WorldState state;
  state.bits.resize((static_cast<size_t>(num_bits_) + 63) / 64);
  state.values.resize(static_cast<size_t>(num_values_), kNoValue);
  state.is_present.resize(objects_.size(), are_present);
  return state;
}

int World::num_places(int symbol) const {
  return powers_[(*symbols_)[symbol].arity];
}

int World::PlaceOf(int symbol, std::span<const int> objects) const {
  int offset = 0;
  for (const int object : objects) offset = offset * num_objects() + object;
  return first(symbol) + offset;
}

std::vector<int> World::ObjectsAt(int symbol, int place) const {
  std::vector<int> objects(static_cast<size_t>((*symbols_)[symbol].arity));
  int offset = place - first(symbol);
  for (size_t i = objects.size(); i-- > 0;) {
    objects[i] = offset % num_objects();
    offset /= num_objects();
  }
  return objects;
}

void World::Set(WorldState* state, int place, bool value) {
  uint64_t& word = state->bits[static_cast<size_t>(place) / 64];
  const uint64_t bit = uint64_t{1} << (place % 64);
  word = value ? word | bit : word & ~bit;
}

void World::Derive(WorldState* state) const {
  for (size_t i = 0; i < symbols_->all().size(); ++i) {
    const int symbol = static_cast<int>(i);
    switch ((*symbols_)[symbol].kind) {
      case Symbol::Kind::kConjunction:
        DeriveConjunction(symbol, state);
        break;
      case Symbol::Kind::kClosure:
        DeriveClosure(symbol, state);
        break;
      case Symbol::Kind::kCount:
        DeriveCount(symbol, state);
        break;
      case Symbol::Kind::kSum:
        DeriveSum(symbol, state);
        break;
      case Symbol::Kind::kAction:
      case Symbol::Kind::kPrimitive:
        break;
    }
  }
}

bool World::Satisfies(const Definition& definition,
                      const std::vector<int>& binding,
                      const WorldState& state) const {
  for (const Definition::Atom& atom : definition.atoms) {
    int offset = 0;
    for (const int variable : atom.variables) {
      offset = offset * num_objects() + binding[static_cast<size_t>(variable)];
    }
    if (Get(state, first(atom.symbol) + offset) == atom.is_negated) {
      return false;
    }
  }
  return true;
}

int World::CountBindings(const Definition& definition,
                         std::vector<int>* binding, const WorldState& state,
                         bool is_satisfied) const {
  if (binding->size() == definition.variables.size()) {
    return Satisfies(definition, *binding, state) == is_satisfied;
  }
  int count = 0;
  binding->push_back(0);
  for (int object = 0; object < num_objects(); ++object) {
    if (!state.is_present[static_cast<size_t>(object)]) continue;
    binding->back() = object;
    count += CountBindings(definition, binding, state, is_satisfied);
  }
  binding->pop_back();
  return count;
}

void World::DeriveConjunction(int symbol, WorldState* state) const {
  const Definition& definition = (*symbols_)[symbol].definition;
  std::vector<int> tuple;
  ForEachTuple(
      (*symbols_)[symbol].arity, *state,
      [&](std::vector<int>& objects) {
        const size_t arity = objects.size();
        const bool holds =
            definition.is_for_all
                ? CountBindings(definition, &objects, *state, false) == 0
                : CountBindings(definition, &objects, *state, true) > 0;
        objects.resize(arity);
        Set(state, PlaceOf(symbol, objects), holds);
      },
      &tuple);
}

void World::DeriveClosure(int symbol, WorldState* state) const {
  const int n = num_objects();
  const int base = first((*symbols_)[symbol].definition.of);
  std::vector<int> open;
  for (int from = 0; from < n; ++from) {
    std::vector<uint8_t> is_reached(static_cast<size_t>(n), 0);
    open.assign(1, from);
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (int to = 0; to < n; ++to) {
        if (is_reached[static_cast<size_t>(to)]) continue;
        if (!Get(*state, base + at * n + to)) continue;
        is_reached[static_cast<size_t>(to)] = 1;
        open.push_back(to);
      }
    }
    for (int to = 0; to < n; ++to) {
      Set(state, first(symbol) + from * n + to,
          is_reached[static_cast<size_t>(to)]);
    }
  }
}

void World::DeriveCount(int symbol, WorldState* state) const {
  const Definition& definition = (*symbols_)[symbol].definition;
  std::vector<int> tuple;
  ForEachTuple(
      (*symbols_)[symbol].arity, *state,
      [&](std::vector<int>& objects) {
        const size_t arity = objects.size();
        const int count = CountBindings(definition, &objects, *state, true);
        objects.resize(arity);
        state->values[static_cast<size_t>(PlaceOf(symbol, objects))] = count;
      },
      &tuple);
}

void World::DeriveSum(int symbol, WorldState* state) const {
  const int of = (*symbols_)[symbol].definition.of;
  int sum = 0;
  for (int i = 0; i < num_places(of); ++i) {
    const int value = state->values[static_cast<size_t>(first(of) + i)];
    if (value != kNoValue) sum += value;
  }
  state->values[static_cast<size_t>(first(symbol))] = sum;
}

std::string World::Show(int symbol, std::span<const int> objects) const {
  std::string text = (*symbols_)[symbol].name + "(";
  for (size_t i = 0; i < objects.size(); ++i) {
    text += (i > 0 ? ", " : "") + objects_[static_cast<size_t>(objects[i])];
  }
  return text + ")";
}

}  // namespace cell::rules
