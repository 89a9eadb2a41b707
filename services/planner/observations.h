#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/relational/state.h"

namespace cell::planner {

/// What was sensed at a key frame.
struct SensedState {
  int64_t key_frame = 0;
  int64_t utime = 0;  ///< [us]
  State state;
};

/// A manipulation that was recognised.
struct DoneAction {
  int64_t index = 0;  ///< names it
  int64_t utime = 0;  ///< [us] of the placement
  int64_t pick_key_frame = 0;
  int64_t place_key_frame = 0;
  std::vector<int> objects;  ///< that it concerned
  std::string text;          ///< "Insert(bolt_1, frame.hole_1)"
  int64_t pick_utime = 0;    ///< [us]
};

}  // namespace cell::planner
