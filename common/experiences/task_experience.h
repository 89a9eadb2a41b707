#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cell/experience_t.hpp"
#include "common/relational/rule.h"
#include "common/relational/state.h"
#include "common/relational/vocabulary.h"
#include "common/result/result.h"

namespace cell {

/// One action and what was sensed before and after it (section V-C). The action
/// is named, since the cell may not know it yet. Atoms may be unknown.
struct TaskExperience {
  std::string action;
  std::vector<int> objects;  ///< of the vocabulary
  Agent agent = Agent::kPerson;
  State before = State(0);
  State after = State(0);
  bool operator==(const TaskExperience&) const = default;
};

Result<TaskExperience> FromMessage(const experience_t& message,
                                   const Vocabulary& vocabulary);
experience_t ToMessage(const TaskExperience& experience,
                       const Vocabulary& vocabulary);

}  // namespace cell
