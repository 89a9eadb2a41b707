#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/relational/literal.h"
#include "common/relational/type_hierarchy.h"
#include "common/result/result.h"
#include "common/sec/event_chain.h"
#include "common/sec/scene_facts.h"

namespace cell {

/// What a demonstration has taught of an action, said of its roles: all that
/// its showings share.
struct Contribution {
  /// How often it was shown, by demonstration; of several demonstrations only
  /// what they share is known.
  std::map<std::string, int> shown;
  std::string build;       ///< that learned it; empty: not known
  std::vector<int> types;  ///< the narrowest, of the objects in the roles
  SceneFacts pick, place;
  EventChain chain;  ///< of the first showing

  bool operator==(const Contribution&) const = default;
};

/// Said of the roles' new places, of which there are as many.
Contribution Renamed(const Contribution& contribution, const RoleMap& places);

/// How an action shows, as it was learned (section VII-A): what all its
/// showings share before the pick-up and after the placement. A value.
struct LearnedModel {
  std::vector<Variable> roles;  ///< with the narrowest types that were shown
  size_t moved = 0;             ///< the role that is picked up and placed
  SceneFacts pick;              ///< before the hand comes
  SceneFacts place;             ///< after the hand has left
  /// Of its first showing: rows of the moved part, as in Showing.
  EventChain chain;
  std::map<std::string, int> shown;  ///< how often, by demonstration
  /// In the order of the demonstrations; none: only their result is known.
  std::vector<Contribution> taught;

  int NumShown() const;
  /// What changes, of predicates of the moved part: without it there is no
  /// such action. As it is before the pick-up.
  LiteralSet RequiredLiterals() const;

  bool operator==(const LearnedModel&) const = default;
  /// The same but for which demonstrations taught it.
  bool SaysTheSame(const LearnedModel& other) const;
};

/// The narrowest type that both are.
int CommonType(const TypeHierarchy& types, int a, int b);

/// For each role the argument of an action that it is. Refused unless there is
/// one argument for each role, whose type the role's is; of several ways the
/// first.
Result<std::vector<size_t>> ArgumentsOf(std::span<const Variable> roles,
                                        std::span<const Variable> arguments,
                                        const TypeHierarchy& types);

/// The model with the action's arguments as roles, in their order and with
/// their types: what was shown with one kind of part may be done with all that
/// the action takes. Refused like ArgumentsOf().
Result<LearnedModel> FitToArguments(const LearnedModel& model,
                                    std::span<const Variable> arguments,
                                    const TypeHierarchy& types);

}  // namespace cell
