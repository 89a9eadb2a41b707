#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "common/rules/experience.h"
#include "common/rules/learning/bit_set.h"
#include "common/rules/learning/feature.h"
#include "common/rules/quantified_atoms.h"

namespace cell::rules {

/// An atom, or function, that an experience changes.
struct Change {
  int symbol = 0;
  std::array<int, kMaxArity> objects = {-1, -1, -1};
  bool is_true = true;
  int value = 0;
  auto operator<=>(const Change&) const = default;
};

/// The experiences of one action, and of every literal and reference that was
/// asked for, in which of them it holds. Each is evaluated once for each
/// experience, also when experiences are added later.
class FeatureTable {
 public:
  FeatureTable(std::shared_ptr<const World> world, int action);

  void Add(const Experience& experience);
  int size() const { return static_cast<int>(examples_.size()); }
  const World& world() const { return *world_; }
  int action() const { return action_; }
  int num_arguments() const { return num_arguments_; }
  const Experience& experience(int e) const { return example(e).experience; }
  const std::vector<Change>& changes(int e) const { return example(e).changes; }
  /// Experiences without any change.
  const BitSet& unchanged() const { return unchanged_; }
  /// Values that the function has had, for any objects.
  const std::set<int>& ValuesOf(int symbol) const {
    return values_[static_cast<size_t>(symbol)];
  }

  /// The number of a literal, which may name references.
  int Number(const Feature& feature);
  const Feature& feature(int number) const {
    return literals_[static_cast<size_t>(number)].feature;
  }
  /// Experiences before which, and after which, it holds.
  const BitSet& Before(int number);
  const BitSet& After(int number);

  /// The term of the reference with this definition, a sorted list.
  /// @throws std::invalid_argument for a literal of a function
  int Reference(const std::vector<Feature>& definition);
  const std::vector<Feature>& definition(int term) const {
    return ReferenceOf(term).definition;
  }
  /// Its object, or -1 if there is not exactly one.
  int Object(int term, int e);
  /// The same for literals that need not be those of a reference.
  int UniqueObject(const std::vector<Feature>& definition, int e);
  const BitSet& Bound(int term);

  /// The object of a term in an experience; -1 if it has none.
  int ObjectOf(int32_t term, int e, int self = -1);
  /// If the literal holds before the experience, with `self` for kSelf.
  bool HoldsBefore(const Feature& feature, int e, int self);

 private:
  struct Example {
    Experience experience;
    std::vector<Change> changes;
    BitSet before;  // the atoms that are true
    BitSet after;
  };
  /// The objects of a literal.
  struct Arguments {
    std::array<int, kMaxArity> objects{};
    size_t number = 0;
    std::span<const int> all() const { return {objects.data(), number}; }
  };
  /// A literal about kSelf in one experience. By first + stride * object it
  /// finds its atom, or, if it says that two terms are the same, their
  /// difference.
  struct SelfLiteral {
    int first = 0;
    int stride = 0;
    bool is_same = false;
    bool is_negated = false;
  };
  struct CachedLiteral {
    Feature feature;
    BitSet before;
    BitSet after;
  };
  struct CachedReference {
    std::vector<Feature> definition;
    std::vector<int> objects;
    BitSet bound;
  };

  const BitSet* OppositeBefore(const Feature& feature) const;
  std::optional<Arguments> ArgumentsOf(const Feature& feature, int e, int self);
  std::optional<SelfLiteral> ToSelfLiteral(const Feature& feature, int e);
  /// With the atoms that are true in the state of the experience.
  bool Holds(const Feature& feature, int e, int self, const WorldState& state,
             const BitSet& atoms);
  const Example& example(int e) const {
    return examples_[static_cast<size_t>(e)];
  }
  CachedReference& ReferenceOf(int term) {
    return references_[static_cast<size_t>(term - num_arguments_)];
  }
  const CachedReference& ReferenceOf(int term) const {
    return references_[static_cast<size_t>(term - num_arguments_)];
  }
  void Extend(CachedReference* reference);

  std::shared_ptr<const World> world_;
  int action_;
  int num_arguments_;
  QuantifiedAtoms atoms_;
  std::deque<Example> examples_;
  BitSet unchanged_;
  std::vector<std::set<int>> values_;  // of each symbol
  std::deque<CachedLiteral> literals_;
  std::map<Feature, int> number_of_;
  std::deque<CachedReference> references_;
  std::map<std::vector<Feature>, int> term_of_;
};

}  // namespace cell::rules
