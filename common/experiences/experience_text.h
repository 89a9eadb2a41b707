#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"

namespace cell {

/// Experiences of a task as rules::ParseExperiences() reads them, without what
/// never changes.
std::string ToText(std::span<const rules::Experience> experiences,
                   const RuleWorld& world);

/// Reads what ToText() writes; what never changes is added.
/// @throws rules::RuleError "file:line: ..." as rules::ParseExperiences(), for
/// objects that the task does not have, and for atoms of objects of a wrong
/// type.
std::vector<rules::Experience> ReadExperiences(const std::string& text,
                                               const std::string& file,
                                               const RuleWorld& world);

}  // namespace cell
