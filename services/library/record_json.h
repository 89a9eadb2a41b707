#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/actions/action_record.h"

namespace cell::library {

/// The record as JSON, its keys in the order of the struct.
/// @throws std::invalid_argument for a text that is not UTF-8.
std::string JsonOf(const ActionRecord& record);
/// Strict: every key must be there with a value of its type, and no other.
/// @param where  begins the error, e.g. "library.json:actions[3]"
/// @throws std::invalid_argument naming where and key.
ActionRecord RecordFromJson(const nlohmann::json& json,
                            const std::string& where);

/// A library's content as text:
///
///   {"format": "actions of a cell", "version": 3, "build": "0.1.0",
///    "actions": [{...}, ...]}
std::string TextOfContent(const std::vector<ActionRecord>& records);
/// @param file  begins the error
/// @throws std::invalid_argument naming file and key.
std::vector<ActionRecord> ContentFromText(const std::string& text,
                                          const std::string& file);

}  // namespace cell::library
