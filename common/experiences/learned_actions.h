#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/experiences/task_experience.h"
#include "common/relational/domain.h"
#include "common/result/result.h"

namespace cell {

/// The actions with the rules that experiences teach (section V-C, see
/// LearnRules()), for a cell that learns while it runs: they rely on nothing
/// that was never shown otherwise, and each says from how many experiences it
/// was learned. Other actions keep what they have. Experiences of actions that
/// are not there, or that do not take such objects, are left out. Refused: a
/// rule that the domain has no words for.
Result<std::vector<Action>> LearnActions(
    std::span<const TaskExperience> experiences,
    std::span<const Action> actions, std::span<const Goal> goals,
    const std::shared_ptr<const Vocabulary>& vocabulary);

}  // namespace cell
