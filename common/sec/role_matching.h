#pragma once

#include <cstddef>
#include <functional>

#include "common/sec/scene_facts.h"

namespace cell {

/// Calls visit(places) for every way to fill the places of a model with the
/// roles of a showing: role 0 takes place 0, every other place gets one of the
/// other roles, and roles without a place are left out. Never, if there are
/// fewer roles than places.
void ForEachMatching(size_t num_roles, size_t num_places,
                     const std::function<void(const RoleMap&)>& visit);

}  // namespace cell
