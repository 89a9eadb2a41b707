#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/rules/experience.h"
#include "common/rules/quantified_atoms.h"
#include "common/rules/rule.h"

namespace cell {

/// Of those that hold as often as not, none of a hundred literals is likely to
/// hold before each of so many successes by accident.
inline constexpr int kManySuccesses = 12;

/// Which of rules::QuantifiedAtoms were ever true, and which always, in states
/// that were seen.
struct SeenAtoms {
  explicit SeenAtoms(int num_atoms)
      : ever(num_atoms), always(num_atoms, true) {}

  /// @param atoms  true in a state
  void Add(const rules::BitSet& atoms);
  void Add(const SeenAtoms& other);
  bool operator==(const SeenAtoms&) const = default;

  rules::BitSet ever;
  rules::BitSet always;
};

/// Makes rules as special as the experiences that they cover and in which they
/// changed something: adds the literals that held before each of them (one in
/// twenty may have been sensed wrongly), and that do not hold always: of these
/// objects, or, if they say that a predicate is true of one, of any other. A
/// few experiences make a rule that is safe, and each further one can only make
/// it more general. So that no accident of how the other parts lie becomes a
/// condition, literals that name no argument of the action are added to rules
/// with many successes only, and those that name no object at all (only `_`)
/// are of landmarks only.
class Specialization {
 public:
  struct Params {
    std::vector<int> landmarks;  ///< symbols
    /// Successes that literals without an argument need.
    int num_for_others = kManySuccesses;
  };
  Specialization(std::shared_ptr<const rules::World> world, Params params);

  const rules::QuantifiedAtoms& atoms() const { return atoms_; }
  const std::vector<int>& landmarks() const { return params_.landmarks; }

  /// @param experiences  of the rule's action
  /// @param bindings  all objects that the action's types allow
  /// @param seen  in the states of all experiences, of any action
  void Apply(std::span<const rules::Experience> experiences,
             std::span<const std::vector<int>> bindings, const SeenAtoms& seen,
             rules::Rule* rule) const;

 private:
  struct Success {
    const rules::Experience* experience;
    rules::BitSet before;  // atoms that were true
  };

  std::vector<Success> SuccessesOf(
      const rules::Rule& rule,
      std::span<const rules::Experience> experiences) const;
  std::vector<rules::Literal> SharedLiterals(
      const rules::Rule& rule, std::span<const Success> successes) const;
  bool IsTelling(const rules::Literal& literal,
                 std::span<const std::vector<int>> bindings,
                 const SeenAtoms& seen) const;
  bool ChangesOfOthers(const rules::Literal& literal,
                       const SeenAtoms& seen) const;

  std::shared_ptr<const rules::World> world_;
  Params params_;
  rules::QuantifiedAtoms atoms_;
};

}  // namespace cell
