#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// Ascending literals, each other than in a task's initial state.
using Changes = std::vector<Literal>;

/// The first set of exactly `size` changes of the task's initial state that
/// `helps`, by trying all; nullopt if there is none. The yardstick for
/// FindExcuses().
/// @param num_tried  if not null, counts the sets that were tried
std::optional<Changes> FindAmongAllChanges(
    const GroundTask& task, int size,
    const std::function<bool(const Changes&)>& helps,
    int64_t* num_tried = nullptr);

}  // namespace cell::planning
