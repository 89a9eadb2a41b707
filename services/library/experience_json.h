#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/experiences/experience_record.h"

namespace cell::library {

/// Its keys are in the order of the struct.
nlohmann::ordered_json ToJson(const ExperienceRecord& experience);
/// @throws std::invalid_argument for a text that is not UTF-8.
std::string JsonOf(const ExperienceRecord& experience);
/// Strict, as RecordFromJson().
/// @throws std::invalid_argument naming where and key.
ExperienceRecord ExperienceFromJson(const nlohmann::json& json,
                                    const std::string& where);

}  // namespace cell::library
