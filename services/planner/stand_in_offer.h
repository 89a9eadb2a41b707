#pragma once

#include <map>
#include <string>

#include "common/relational/rule_set.h"
#include "common/sec/learned_model.h"
#include "services/planner/execution_status.h"

namespace cell::planner {

/// How actions show, by their names.
using SecModels = std::map<std::string, LearnedModel>;

/// Adds to a question about a missing part what could be used instead, by the
/// role that the part plays in an action that needs it: "; bolt_2 could stand
/// in for bolt_1". If nothing is asked for but the missing part, to place the
/// first of these instead becomes the question's step. Changes nothing if no
/// part is missing, or nothing could stand in for it.
void OfferStandIns(const SecModels& models, const RuleSet& rules,
                   const State& state, ExecutionStatus* question);

}  // namespace cell::planner
