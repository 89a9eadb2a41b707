#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"

namespace cell::cli {

/// The experiences of one run, as `cell rules record` writes them below a line
/// "# SCRIPT, seed N".
struct ExperiencedEpisode {
  std::string name;  ///< of that line
  std::vector<rules::Experience> experiences;
};

/// Of all files *.experiences of a folder, by their names. Episodes without
/// experiences are left out.
/// @throws std::runtime_error if there is none, rules::RuleError "file:line:"
std::vector<ExperiencedEpisode> EpisodesIn(const std::filesystem::path& folder,
                                           const RuleWorld& world);

}  // namespace cell::cli
