#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"
#include "common/task/task.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {

/// The experiences of a run, episode by episode (section V-C), as the cell
/// itself has them: states as sensed (PREDICATES), manipulations as recognised
/// (ACTION), those of people and of arms alike, skills that were begun and
/// failed (SKILL_REQUEST, SKILL_RESULT), and what a person says to have tried
/// in vain (ATTEMPT). What was recognised as an action taken back is an
/// experience of the action that undoes it. Ground truth is not read. What was
/// recognised as an action reversed that no other action undoes is, reversed,
/// an experience of the action itself.
/// @param world  of the task of the run
/// @throws std::runtime_error if there is no whole log.
std::vector<rules::Experience> ExperiencesOfRun(const RunFolder& run,
                                                const RuleWorld& world);

/// The same of a simulated run of a script, of which no log is kept.
/// @throws std::runtime_error if it is stopped by a signal.
std::vector<rules::Experience> ExperiencesOfSimulation(
    const Deployment& deployment, const Roster& roster,
    const std::string& script, uint64_t seed, const RuleWorld& world);

RuleWorld RuleWorldOf(const Domain& domain);

}  // namespace cell::cli
