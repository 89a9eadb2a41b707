#pragma once

#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// Two books on a shelf, then the lid of the shelf, which closes it.
inline constexpr char kPlacingTask[] = R"(
objects: red blue lid
start: book(red) book(blue) cover(lid)
goal: placed(red) placed(blue) closed()
book 1 primitive
cover 1 primitive
placed 1 primitive
closed 0 primitive
place 1 action <-- book(X)
close 1 action <-- cover(X)

Action: place(X)
Preconditions: not placed(X), not closed()
Effects:
  1: placed(X)
  0: noise

Action: close(X)
Preconditions: not closed()
Effects:
  1: closed()
  0: noise
)";

inline RexdTask PlacingTask() {
  return ParseRexdTask(kPlacingTask, "t");
}

}  // namespace cell::rexd
