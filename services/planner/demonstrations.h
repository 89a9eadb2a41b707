#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/experiences/task_experience.h"
#include "services/planner/observations.h"

namespace cell::planner {

/// A manipulation that a person has shown.
struct ShownAction {
  std::string action;        ///< name
  std::vector<int> objects;  ///< of the vocabulary
  /// What was before it is after the action.
  bool is_reversed = false;
  int64_t pick_key_frame = 0;
  int64_t place_key_frame = 0;
};

/// Makes experiences (section V-C) of what people show in an episode. The state
/// before a manipulation is that of the last key frame before the part was
/// picked up; the state after it is that of the key frame at which it was
/// placed. Simplification: what another hand does meanwhile is taken for an
/// effect; that concerns other objects, which rules do not rely on.
class Demonstrations {
 public:
  /// Keeps what was sensed at so many key frames.
  static constexpr size_t kMaxRemembered = 256;

  void Clear();
  void Update(const SensedState& sensed);
  void Update(const ShownAction& shown);

  /// Those that are complete, each once.
  std::vector<TaskExperience> Take();

 private:
  std::optional<TaskExperience> Of(const ShownAction& shown) const;

  std::map<int64_t, State> states_;  // first sensed at a key frame
  std::deque<ShownAction> waiting_;  // for the state at their key frame
};

}  // namespace cell::planner
