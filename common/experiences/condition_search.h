#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "common/experiences/variable_types.h"
#include "common/rules/experience.h"
#include "common/rules/learning/bit_set.h"
#include "common/rules/quantified_atoms.h"
#include "common/rules/rule.h"

namespace cell {

/// An experience, the objects of a rule's variables in it, and the atoms that
/// were true before it.
struct BoundExperience {
  const rules::Experience* experience;
  std::vector<int> binding;
  rules::BitSet before;
};

/// Finds the conditions under which an action changes one atom of any object.
///
/// Each object whose atom has the other truth before an experience is an
/// example: positive if the atom has changed after it. Conjunctions of literals
/// are found by sequential covering (FOIL, Quinlan 1990): the literal that
/// tells positive from negative ones best is added until no negative one is
/// left, then those that are not needed are removed; until all positive ones
/// are covered. A condition that too few experiences support is left out.
///
/// Of other objects than those it was found by, nothing is known. So conditions
/// are looked for in the objects of one type at a time; equal ones become one
/// of the common type. And a condition begins with a landmark, which says what
/// had been done with them, where that leads to one that examples agree on.
class ConditionSearch {
 public:
  /// All but the world's must outlive it.
  /// @param change  of the variable after those of the rule
  /// @param candidates  literals that conditions may have
  /// @param landmarks   symbols that say what has been done with an object
  ConditionSearch(const std::vector<BoundExperience>& experiences,
                  const rules::Literal& change,
                  const std::vector<rules::Literal>& candidates,
                  std::span<const int> landmarks, const VariableTypes& types,
                  const rules::QuantifiedAtoms& atoms,
                  const rules::World& world);

  /// Each is a conjunction; the change happens where one of them holds.
  std::vector<std::vector<rules::Literal>> Run();

 private:
  struct Example {
    size_t experience = 0;
    int object = 0;
    bool is_positive = false;
  };
  struct Candidate {
    rules::Literal literal;
    rules::BitSet holds;       ///< examples
    bool is_landmark = false;  ///< says what has been done with the object
  };
  using Condition = std::vector<size_t>;  // literals, in order

  /// Experiences that must agree on an effect.
  static constexpr size_t kLeastExperiences = 2;

  int size() const { return static_cast<int>(examples_.size()); }
  void FindExamples();
  std::set<int> TypesOfPositive() const;
  std::vector<Condition> FindConditions() const;
  int PlaceFor(const BoundExperience& bound, int object) const;
  rules::BitSet ExamplesWith(const rules::Literal& literal) const;
  rules::BitSet CoveredBy(const Condition& condition) const;
  size_t NumExperiences(const rules::BitSet& examples) const;
  bool IsSupported(const rules::BitSet& positive) const {
    return NumExperiences(positive) >= kLeastExperiences;
  }
  bool IsAgreed(const Condition& condition, const rules::BitSet& open) const;
  std::vector<rules::Literal> LiteralsOf(const Condition& condition) const;
  Condition Grow(const rules::BitSet& open,
                 std::optional<size_t> landmark) const;
  std::optional<size_t> BestLandmark(const rules::BitSet& open) const;
  std::optional<size_t> BestLiteral(const Condition& condition,
                                    const rules::BitSet& covered,
                                    bool is_of_object) const;
  double Gain(const rules::BitSet& covered, const rules::BitSet& holds) const;
  Condition WithType(Condition condition,
                     const std::vector<int>& objects) const;
  int KnownType(const Condition& condition) const;
  Condition Prune(Condition condition) const;

  const std::vector<BoundExperience>& experiences_;
  const rules::Literal& change_;
  const VariableTypes& types_;
  const rules::QuantifiedAtoms& atoms_;
  const rules::World& world_;
  std::vector<Example> examples_;
  rules::BitSet positive_;
  rules::BitSet within_;  // of the type that is looked at
  std::vector<Candidate> literals_;
};

}  // namespace cell
