#pragma once

#include <map>
#include <optional>
#include <string>

#include "cell/asked_skill_t.hpp"

namespace cell {

/// Values by the names of a skill's arguments.
using SkillArguments = std::map<std::string, std::string>;

/// Returns nullopt if a name is empty or occurs twice, or if too many.
std::optional<SkillArguments> ArgumentsOf(const asked_skill_t& request);
/// Empty if it has none of that name.
std::string ArgumentOf(const asked_skill_t& request, const std::string& name);
void SetArguments(const SkillArguments& arguments, asked_skill_t* request);

}  // namespace cell
