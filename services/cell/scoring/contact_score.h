#pragma once

#include <cstdint>
#include <vector>

#include "services/cell/scoring/contact_events.h"

namespace cell::cli {

/// How well found contact events agree with the true ones.
struct ContactScore {
  int num_true = 0, num_found = 0;
  int num_matched = 0;  ///< one to one: same pair and kind, near in time
  int num_actions = 0;  ///< a hand takes a part, until it lets go
  /// Actions whose event chain has exactly the true changes, in the true order;
  /// changes nearer in time than the tolerance may come in any order.
  int num_exact = 0;
  /// Actions whose event chain has exactly the true columns, where changes
  /// within `merge_us` are one.
  int num_same_columns = 0;

  ContactScore& operator+=(const ContactScore& other);
};

struct ContactScoreParams {
  int64_t tolerance_us = 300'000;  ///< of an event's time
  int64_t merge_us = 150'000;      ///< of the key frames: sec_builder.yaml
};

/// @pre events are ordered by utime.
ContactScore ScoreContacts(const std::vector<ContactEvent>& truth,
                           const std::vector<ContactEvent>& found,
                           const SceneObjects& scene_objects,
                           const ContactScoreParams& params);

}  // namespace cell::cli
