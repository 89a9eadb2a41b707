#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/relational/domain.h"
#include "common/rules/experience.h"

namespace cell::cli {

/// What a library has experienced, in the words of a task and of the actions
/// that the library knows.
struct LibraryExperiences {
  RuleWorld world;
  std::vector<rules::Experience> experiences;
  /// In which each of them was made; empty: not known.
  std::vector<std::string> demonstrations;
  /// Why others are left out, one each.
  std::vector<std::string> left_out;
};

/// Reads a library's file. Left out are experiences of
/// actions that the library does not know or has removed, and those that name
/// other objects than the task has, or than the action takes.
/// @param domain  of the task; its actions are replaced by the library's
/// @throws StoreError; ConfigError if an action is not of the task
LibraryExperiences ReadLibraryExperiences(const std::filesystem::path& file,
                                          Domain domain);

/// A line for each experience that is left out.
void PrintLeftOut(const LibraryExperiences& experiences);

}  // namespace cell::cli
