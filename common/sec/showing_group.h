#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/relational/type_hierarchy.h"
#include "common/result/result.h"
#include "common/sec/learned_model.h"
#include "common/sec/showing.h"

namespace cell {

/// Showings of one action, said of its roles, of which role 0 is moved. What
/// they share follows from what each demonstration has taught, so that a
/// demonstration can be taken back. A value.
struct ShowingGroup {
  /// So many demonstrations are kept apart; what is older becomes one.
  static constexpr size_t kMaxTaught = 16;

  std::string name;                  ///< of the action
  bool is_named = false;             ///< by a person
  std::vector<int> types;            ///< of the roles; none: the group is gone
  SceneFacts pick, place;            ///< what all showings share
  EventChain chain;                  ///< of the first showing
  std::vector<Contribution> taught;  ///< in the order of the demonstrations
  std::vector<int> least_types;      ///< types are these or wider; may be empty

  bool is_gone() const { return types.empty(); }
  std::map<std::string, int> Shown() const;
  /// All of it as if it were one showing.
  Showing AsShowing() const;

  void Add(Contribution contribution, const TypeHierarchy& hierarchy);
  /// Takes over all that the other was taught; `places`: of its roles here.
  /// @pre all its roles have a place.
  void Absorb(const ShowingGroup& other, const RoleMap& places,
              const TypeHierarchy& hierarchy);
  /// @pre one type for each role
  void Widen(const std::vector<int>& wider, const TypeHierarchy& hierarchy);
  /// Forgets what the demonstration has taught; nothing remains of a group that
  /// no other has taught. True if it has taught any of it. Refused if it cannot
  /// be told from what others have taught.
  Result<bool> TakeBack(const std::string& demonstration,
                        const TypeHierarchy& hierarchy);

 private:
  void Share(const TypeHierarchy& hierarchy);
};

/// What a showing of `source` teaches a group of so many roles.
Contribution ContributionOf(const Showing& showing, const RoleMap& places,
                            size_t num_roles, const std::string& source,
                            const std::string& build);

/// The group of the same showings read backwards.
ShowingGroup Reversed(const ShowingGroup& group);

}  // namespace cell
