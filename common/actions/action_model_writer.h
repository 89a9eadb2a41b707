#pragma once

#include <span>
#include <vector>

#include "common/actions/action_model.h"
#include "common/actions/action_record.h"
#include "common/relational/domain.h"

namespace cell {

/// The record that ReadActionModel() reads as this model; its id is 0.
ActionRecord WriteActionModel(const ActionModel& model, const Domain& domain);

/// The same of all of them, in their order.
std::vector<ActionRecord> WriteActionModels(std::span<const ActionModel> models,
                                            const Domain& domain);

}  // namespace cell
