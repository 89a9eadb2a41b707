#pragma once

#include <vector>

#include "common/config/config.h"
#include "services/library/action_record.h"

namespace cell::library {

/// The action as it would stand in a task's domain.yaml, but for `undoes`: for
/// LoadAction() and Gallery::Read(). Errors begin with its name.
/// @throws ConfigError for texts that are not one YAML document each, without
/// anchors.
Config ConfigOf(const ActionRecord& record);

/// The actions that were written by hand: the block `actions` of a domain.yaml
/// that Domain::FromConfig() has accepted.
std::vector<ActionRecord> TaskActions(const Config& domain_config);

}  // namespace cell::library
