#pragma once

#include <memory>

#include "common/config/deployment.h"
#include "common/relational/domain.h"
#include "services/planner/decision_maker.h"

namespace cell::planner {

/// The decision maker that the task's domain and the service's planner.yaml
/// describe. @throws ConfigError naming file:key.
std::unique_ptr<DecisionMaker> LoadDecisionMaker(const Domain& domain,
                                                 const Deployment& deployment);

}  // namespace cell::planner
