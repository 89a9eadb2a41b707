#pragma once

#include <optional>
#include <vector>

#include "common/relational/literal.h"
#include "common/sec/event_chain.h"
#include "common/sec/scene_facts.h"
#include "common/sec/scene_words.h"
#include "common/sec/sec_library.h"

namespace cell {

/// A manipulation as a learner sees it: not which objects took part, but in
/// which roles, and what was true before the pick-up and after the placement.
/// Role 0 is the part that was moved; the others are the objects of predicates
/// that changed together with it.
struct Showing {
  Binding objects;         ///< of the roles
  std::vector<int> types;  ///< of these objects
  SceneFacts pick;         ///< all that is known over the roles before it
  SceneFacts place;        ///< and after it
  /// Rows of the moved part and its partners by type, without hands; columns
  /// that differ from the one before.
  EventChain chain;

  /// Stands for the moved part in the chain.
  static constexpr char kMoved[] = "moved part";

  /// The same manipulation read backwards.
  Showing Reversed() const;
};

/// At most so many roles; what relates a part to more objects at once is no
/// showing of one action.
inline constexpr size_t kMaxRoles = 5;

/// Nothing if no predicate and no relation of the moved part differs between
/// the two scenes, or the part is unknown.
std::optional<Showing> Lift(const ObservedManipulation& manipulation,
                            const SceneWords& words);

}  // namespace cell
