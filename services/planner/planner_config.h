#pragma once

#include <memory>

#include "common/config/deployment.h"
#include "services/planner/decision_maker.h"

namespace cell::planner {

/// The decision maker that the task's domain.yaml and the service's
/// planner.yaml describe. @throws ConfigError naming file:key.
std::unique_ptr<DecisionMaker> LoadDecisionMaker(const Deployment& deployment);

}  // namespace cell::planner
