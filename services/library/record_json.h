#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/actions/action_record.h"

namespace cell::library {

/// Its keys are in the order of the struct.
nlohmann::ordered_json ToJson(const ActionRecord& record);
/// @throws std::invalid_argument for a text that is not UTF-8.
std::string JsonOf(const ActionRecord& record);
/// Strict: every key must be there with a value of its type, and no other.
/// @param where  begins the error, e.g. "library.json:actions[3]"
/// @throws std::invalid_argument naming where and key.
ActionRecord RecordFromJson(const nlohmann::json& json,
                            const std::string& where);

}  // namespace cell::library
