#pragma once

#include "cell/motion_plan_t.hpp"
#include "cell/motion_request_t.hpp"
#include "common/arms/motion_request.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/result/result.h"

namespace cell {

motion_request_t ToMessage(const MotionRequest& request);

/// A reason if it names a part, an arm or a grip that there is not, if joints
/// are not as many as the arm's or beyond its limits, a number is not finite or
/// a field that its kind needs is missing.
Result<MotionRequest> FromMessage(const motion_request_t& message,
                                  const PartTable& parts,
                                  const CellLayout& layout);

/// Of a request that was measured at `utime`.
motion_plan_t ToMessage(const MotionPlan& plan, int64_t utime);

/// A reason if joints are not as many as the arm's or beyond its limits, a
/// number is not finite, or `is_found` and the reason contradict each other.
Result<MotionPlan> FromMessage(const motion_plan_t& message,
                               const CellLayout& layout);

}  // namespace cell
