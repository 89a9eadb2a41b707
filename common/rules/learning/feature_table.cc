#include "common/rules/learning/feature_table.h"

#include <algorithm>
#include <stdexcept>

namespace cell::rules {
namespace {

/// The primitive atoms and functions in which two states differ.
std::vector<Change> ChangesOf(const Experience& experience,
                              const World& world) {
  std::vector<Change> changes;
  const auto add = [&](int symbol, int place, bool is_true, int value) {
    Change change{symbol, {-1, -1, -1}, is_true, value};
    const std::vector<int> objects = world.ObjectsAt(symbol, place);
    std::ranges::copy(objects, change.objects.begin());
    changes.push_back(change);
  };
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const Symbol& symbol = world.symbols().all()[s];
    if (symbol.kind != Symbol::Kind::kPrimitive) continue;
    const int first = world.first(static_cast<int>(s));
    const int end = first + world.num_places(static_cast<int>(s));
    for (int place = first; place < end; ++place) {
      if (symbol.is_integer) {
        const int after = experience.after.values[static_cast<size_t>(place)];
        if (after == experience.before.values[static_cast<size_t>(place)] ||
            after == World::kNoValue) {
          continue;
        }
        add(static_cast<int>(s), place, true, after);
        continue;
      }
      if (place % 64 == 0 && place + 64 <= end &&
          experience.before.bits[static_cast<size_t>(place) / 64] ==
              experience.after.bits[static_cast<size_t>(place) / 64]) {
        place += 63;
        continue;
      }
      const bool after = World::Get(experience.after, place);
      if (after != World::Get(experience.before, place)) {
        add(static_cast<int>(s), place, after, 0);
      }
    }
  }
  return changes;
}

}  // namespace

FeatureTable::FeatureTable(std::shared_ptr<const World> world, int action)
    : world_(std::move(world)),
      action_(action),
      num_arguments_(world_->symbols()[action].arity),
      atoms_(world_),
      values_(world_->symbols().all().size()) {}

void FeatureTable::Add(const Experience& experience) {
  const int e = size();
  examples_.push_back({experience, ChangesOf(experience, *world_),
                       atoms_.TrueIn(experience.before),
                       atoms_.TrueIn(experience.after)});
  unchanged_.Resize(e + 1);
  if (changes(e).empty()) unchanged_.Add(e);
  for (size_t s = 0; s < values_.size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (!world_->symbols()[symbol].is_integer) continue;
    for (int i = 0; i < world_->num_places(symbol); ++i) {
      const auto place = static_cast<size_t>(world_->first(symbol) + i);
      const int value = experience.before.values[place];
      if (value != World::kNoValue) values_[s].insert(value);
    }
  }
}

int FeatureTable::Number(const Feature& feature) {
  const auto [it, is_new] =
      number_of_.emplace(feature, static_cast<int>(literals_.size()));
  if (is_new) literals_.push_back({feature, BitSet(), BitSet()});
  return it->second;
}

/// Where the opposite literal is known and there is an object for each of its
/// terms, this one is its complement.
const BitSet* FeatureTable::OppositeBefore(const Feature& feature) const {
  for (const int32_t term : feature.terms) {
    if (term >= num_arguments_ || term == Feature::kSelf) return nullptr;
  }
  if (feature.comparison != Comparison::kFalse) return nullptr;
  const auto it = number_of_.find(feature.Negated());
  if (it == number_of_.end()) return nullptr;
  const BitSet& before = literals_[static_cast<size_t>(it->second)].before;
  return before.size() == size() ? &before : nullptr;
}

const BitSet& FeatureTable::Before(int number) {
  CachedLiteral& literal = literals_[static_cast<size_t>(number)];
  if (literal.before.size() < size()) {
    if (const BitSet* opposite = OppositeBefore(literal.feature)) {
      literal.before = BitSet(size(), true);
      literal.before -= *opposite;
    }
  }
  for (int e = literal.before.size(); e < size(); ++e) {
    literal.before.Resize(e + 1);
    if (HoldsBefore(literal.feature, e, -1)) literal.before.Add(e);
  }
  return literal.before;
}

const BitSet& FeatureTable::After(int number) {
  CachedLiteral& literal = literals_[static_cast<size_t>(number)];
  for (int e = literal.after.size(); e < size(); ++e) {
    literal.after.Resize(e + 1);
    if (Holds(literal.feature, e, -1, experience(e).after, example(e).after)) {
      literal.after.Add(e);
    }
  }
  return literal.after;
}

int FeatureTable::Reference(const std::vector<Feature>& definition) {
  for (const Feature& feature : definition) {
    if (feature.symbol != Literal::kSame &&
        world_->symbols()[feature.symbol].is_integer) {
      throw std::invalid_argument("a function does not define a reference");
    }
  }
  const int next = num_arguments_ + static_cast<int>(references_.size());
  const auto [it, is_new] = term_of_.emplace(definition, next);
  if (is_new) references_.push_back({definition, {}, BitSet()});
  return it->second;
}

std::optional<FeatureTable::SelfLiteral> FeatureTable::ToSelfLiteral(
    const Feature& feature, int e) {
  const auto with_first = ArgumentsOf(feature, e, 0);
  const auto with_second = ArgumentsOf(feature, e, 1);
  if (!with_first || !with_second) return std::nullopt;
  const bool is_same = feature.symbol == Literal::kSame;
  const auto number = [&](const Arguments& arguments) {
    return is_same ? arguments.objects[0] - arguments.objects[1]
                   : atoms_.IndexOf(feature.symbol, arguments.all());
  };
  const int first = number(*with_first);
  return SelfLiteral{first, number(*with_second) - first, is_same,
                     feature.comparison == Comparison::kFalse};
}

int FeatureTable::UniqueObject(const std::vector<Feature>& definition, int e) {
  std::vector<SelfLiteral> literals;
  for (const Feature& feature : definition) {
    const auto literal = ToSelfLiteral(feature, e);
    if (!literal) return -1;
    literals.push_back(*literal);
  }
  const BitSet& atoms = example(e).before;
  const auto is_it = [&](int object) {
    return std::ranges::all_of(literals, [&](const SelfLiteral& literal) {
      const int number = literal.first + literal.stride * object;
      const bool is_true = literal.is_same ? number == 0 : atoms.Has(number);
      return is_true != literal.is_negated;
    });
  };
  int found = -1;
  for (int object = 0; object < world_->num_objects(); ++object) {
    if (!experience(e).before.is_present[static_cast<size_t>(object)]) continue;
    if (!is_it(object)) continue;
    if (found >= 0) return -1;
    found = object;
  }
  return found;
}

void FeatureTable::Extend(CachedReference* reference) {
  for (int e = reference->bound.size(); e < size(); ++e) {
    const int object = UniqueObject(reference->definition, e);
    reference->bound.Resize(e + 1);
    if (object >= 0) reference->bound.Add(e);
    reference->objects.push_back(object);
  }
}

int FeatureTable::Object(int term, int e) {
  CachedReference& reference = ReferenceOf(term);
  if (e >= reference.bound.size()) Extend(&reference);
  return reference.objects[static_cast<size_t>(e)];
}

const BitSet& FeatureTable::Bound(int term) {
  CachedReference& reference = ReferenceOf(term);
  if (reference.bound.size() < size()) Extend(&reference);
  return reference.bound;
}

int FeatureTable::ObjectOf(int32_t term, int e, int self) {
  if (term == Feature::kSelf) return self;
  if (term < 0) return term < Feature::kNone ? Feature::ObjectOf(term) : -1;
  if (term < num_arguments_) {
    return experience(e).act.arguments[static_cast<size_t>(term)];
  }
  return Object(term, e);
}

bool FeatureTable::HoldsBefore(const Feature& feature, int e, int self) {
  return Holds(feature, e, self, experience(e).before, example(e).before);
}

/// The objects of the literal's terms, `_` as that of the atoms; none, if a
/// term has none.
std::optional<FeatureTable::Arguments> FeatureTable::ArgumentsOf(
    const Feature& feature, int e, int self) {
  Arguments found;
  for (const int32_t term : feature.terms) {
    if (term == Feature::kNone) break;
    const int object =
        term == Feature::kAny ? atoms_.any() : ObjectOf(term, e, self);
    if (object < 0) return std::nullopt;
    found.objects[found.number++] = object;
  }
  return found;
}

bool FeatureTable::Holds(const Feature& feature, int e, int self,
                         const WorldState& state, const BitSet& atoms) {
  const auto arguments = ArgumentsOf(feature, e, self);
  if (!arguments) return false;
  const bool is_negated = feature.comparison == Comparison::kFalse;
  if (feature.symbol == Literal::kSame) {
    return (arguments->objects[0] == arguments->objects[1]) != is_negated;
  }
  if (world_->symbols()[feature.symbol].is_integer) {
    const int place = world_->PlaceOf(feature.symbol, arguments->all());
    return Compare(feature.comparison, state.values[static_cast<size_t>(place)],
                   feature.value);
  }
  const int atom = atoms_.IndexOf(feature.symbol, arguments->all());
  return atoms.Has(atom) != is_negated;
}

}  // namespace cell::rules
