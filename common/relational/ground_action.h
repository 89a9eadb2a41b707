#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/relational/rule.h"

namespace cell {

/// Place of the action among `actions`; nullopt if there is none of that name.
std::optional<int> FindAction(std::span<const Action> actions,
                              const std::string& name);

/// All combinations of objects that the arguments' types allow and for which
/// some rule's static literals hold; in the order of actions and objects.
std::vector<GroundAction> GroundActions(std::span<const Action> actions,
                                        const Vocabulary& vocabulary,
                                        Agent agent);

/// The action with these objects; nullopt unless names, number and types are
/// right.
std::optional<GroundAction> FindGroundAction(
    std::span<const Action> actions, const Vocabulary& vocabulary,
    const std::string& name, const std::vector<std::string>& objects);

}  // namespace cell
