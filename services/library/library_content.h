#pragma once

#include <cstdint>
#include <vector>

#include "common/actions/action_record.h"
#include "common/experiences/experience_record.h"

namespace cell::library {

/// What a library holds.
struct LibraryContent {
  std::vector<ActionRecord> actions;  ///< the latest of each name, by id
  std::vector<ExperienceRecord> experiences;  ///< by id
  int64_t last_experience = 0;  ///< highest id of an experience ever given
};

/// What is stored in a library at once: all of it or nothing.
struct StoreEdit {
  std::vector<ActionRecord> records;          ///< in this order
  std::vector<ExperienceRecord> experiences;  ///< the ids do not count
  std::vector<int64_t> removed_experiences;   ///< ids

  bool has_experiences() const {
    return !experiences.empty() || !removed_experiences.empty();
  }
};

/// The ids of what was stored, in the order of a StoreEdit.
struct StoredIds {
  std::vector<int64_t> records;
  std::vector<int64_t> experiences;
};

}  // namespace cell::library
