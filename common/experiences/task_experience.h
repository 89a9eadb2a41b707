#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cell/experience_t.hpp"
#include "common/relational/rule.h"
#include "common/relational/state.h"
#include "common/relational/vocabulary.h"
#include "common/result/result.h"

namespace cell {

/// One action and what was sensed before and after it (section V-C). The action
/// is named, since the cell may not know it yet. Atoms may be unknown. The
/// states may be equal: the action changed nothing.
struct TaskExperience {
  static constexpr size_t kMaxName = 64;     ///< of the action [characters]
  static constexpr size_t kMaxObjects = 16;  ///< of the action

  std::string action;
  std::vector<int> objects;  ///< of the vocabulary
  Agent agent = Agent::kPerson;
  State before = State(0);
  State after = State(0);
  bool operator==(const TaskExperience&) const = default;
};

/// The reason why there is none names the place in the message and what would
/// be right: a name that is none, an object or a predicate that the vocabulary
/// does not have, an atom of other objects than the predicate takes, one that
/// is there twice, or one that is said to be false.
Result<TaskExperience> FromMessage(const experience_t& message,
                                   const Vocabulary& vocabulary);
/// All but the header and the id; the atoms in the vocabulary's order.
experience_t ToMessage(const TaskExperience& experience,
                       const Vocabulary& vocabulary);

}  // namespace cell
