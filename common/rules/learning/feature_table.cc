#include "common/rules/learning/feature_table.h"

#include <algorithm>

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
      values_(world_->symbols().all().size()) {}

void FeatureTable::Add(const Experience& experience) {
  const int e = size();
  experiences_.push_back(experience);
  changes_.push_back(ChangesOf(experience, *world_));
  unchanged_.Resize(e + 1);
  if (changes_.back().empty()) unchanged_.Add(e);
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
    if (Holds(literal.feature, e, -1, experience(e).before)) {
      literal.before.Add(e);
    }
  }
  return literal.before;
}

const BitSet& FeatureTable::After(int number) {
  CachedLiteral& literal = literals_[static_cast<size_t>(number)];
  for (int e = literal.after.size(); e < size(); ++e) {
    literal.after.Resize(e + 1);
    if (Holds(literal.feature, e, -1, experience(e).after)) {
      literal.after.Add(e);
    }
  }
  return literal.after;
}

int FeatureTable::Reference(const std::vector<Feature>& definition) {
  const int next = num_arguments_ + static_cast<int>(references_.size());
  const auto [it, is_new] = term_of_.emplace(definition, next);
  if (is_new) references_.push_back({definition, {}, BitSet()});
  return it->second;
}

void FeatureTable::Extend(CachedReference* reference) {
  for (int e = reference->bound.size(); e < size(); ++e) {
    int found = -1;
    int num_found = 0;
    for (int object = 0; object < world_->num_objects(); ++object) {
      if (!experience(e).before.is_present[static_cast<size_t>(object)]) {
        continue;
      }
      const bool is_it =
          std::ranges::all_of(reference->definition, [&](const Feature& f) {
            return Holds(f, e, object, experience(e).before);
          });
      if (!is_it) continue;
      found = object;
      if (++num_found > 1) break;
    }
    reference->bound.Resize(e + 1);
    if (num_found == 1) reference->bound.Add(e);
    reference->objects.push_back(num_found == 1 ? found : -1);
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
  return Holds(feature, e, self, experience(e).before);
}

bool FeatureTable::Holds(const Feature& feature, int e, int self,
                         const WorldState& state) {
  const int arity = feature.symbol == Literal::kSame
                        ? 2
                        : world_->symbols()[feature.symbol].arity;
  // As a literal whose variables are its own terms, one by one. Looking up the
  // object of a reference may evaluate other literals: that comes first.
  std::array<int, kMaxArity> binding = {0, 0, 0};
  for (size_t i = 0; i < static_cast<size_t>(arity); ++i) {
    if (feature.terms[i] == Feature::kAny) continue;
    binding[i] = ObjectOf(feature.terms[i], e, self);
    if (binding[i] < 0) return false;
  }
  scratch_.symbol = feature.symbol;
  scratch_.comparison = feature.comparison;
  scratch_.value = feature.value;
  scratch_.terms.resize(static_cast<size_t>(arity));
  for (size_t i = 0; i < static_cast<size_t>(arity); ++i) {
    scratch_.terms[i] = {feature.terms[i] == Feature::kAny
                             ? Term::Kind::kAny
                             : Term::Kind::kVariable,
                         static_cast<int>(i)};
  }
  return rules::Holds(scratch_, binding, state, *world_);
}

}  // namespace cell::rules
