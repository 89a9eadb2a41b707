#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/planning/all_changes.h"
#include "common/rules/simulation.h"

namespace cell::cli {

/// Most actions between where a task begins and the state that is asked about.
inline constexpr int kMaxWalk = 12;

/// One of a list that is not empty, at random.
template <class T>
T& OneOf(std::vector<T>& list, rules::RandomNumbers* random) {
  return list[static_cast<size_t>(
      random->Below(static_cast<int>(list.size())))];
}

/// What is done to a domain so that plans are lost.
enum class Damage { kRule, kEffect, kPrecondition };
std::string ToText(Damage damage);

/// A state of a damaged domain from which there is no way to the goal, and what
/// is said about it.
struct ExcuseCase {
  Damage damage = Damage::kRule;
  std::string what;               ///< "placeLid(X) needs red(X)"
  std::set<std::string> missing;  ///< predicates that the damage is about
  planning::GroundTask task;      ///< of the damaged domain, from the state
  /// All that are told, the best first.
  std::vector<planning::Changes> excuses;
  std::string text;  ///< the guidance, in words
  /// Whether the planner finds a plan when any of the excuses is applied to the
  /// state of the domain itself and everything is set up from there.
  bool helps = false;
};

/// A domain to be damaged.
class DamagedDomain {
 public:
  DamagedDomain() = default;
  DamagedDomain(const DamagedDomain&) = delete;
  DamagedDomain& operator=(const DamagedDomain&) = delete;
  virtual ~DamagedDomain() = default;

  /// Damages the domain and goes to a state, both at random; nullopt if there
  /// is a plan all the same. Equal seeds give equal cases.
  virtual std::optional<ExcuseCase> Draw(uint64_t seed) const = 0;
};

/// What is true of a case's excuses.
struct ExcuseVerdict {
  int size = 0;              ///< changes of the best excuse; 0: none was found
  bool is_minimal = false;   ///< all of them
  bool has_missing = false;  ///< one holds a predicate that is missing
  bool is_first = false;     ///< the best one does
  bool is_named = false;     ///< the text names that predicate's literal
  /// Whether any set of as few changes that holds a predicate that is missing
  /// would help.
  bool may_hold_missing = false;
  int64_t num_tried = 0;  ///< sets of changes
};

/// Checks a case by trying all smaller sets of up to three changes, and those
/// of the excuses' size if none of them holds what is missing.
ExcuseVerdict Judge(const ExcuseCase& excuse_case);

/// The first case, of the seeds that follow from `seed`, in which what is
/// missing belongs to some smallest change; with the numbers of draws that had
/// a plan, or in which a change of something else is smaller.
nlohmann::json ExcuseRow(const DamagedDomain& domain, uint64_t seed);

}  // namespace cell::cli
