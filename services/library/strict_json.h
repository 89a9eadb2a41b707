#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace cell::library {

/// @throws std::invalid_argument "file:line: is not JSON"; without a line for a
/// number that is too large.
nlohmann::json ParseJson(const std::string& text, const std::string& file);

/// Reading of JSON that lets nothing pass: every key must be there with a value
/// of its type, and no other. `where` begins each error, e.g.
/// "library.json:actions[3]".
/// @throws std::invalid_argument "where: what is wrong".
[[noreturn]] void FailAt(const std::string& where, const std::string& what);
void RequireObject(const nlohmann::json& value, const std::string& where,
                   const std::vector<std::string_view>& keys);
std::string TextAt(const nlohmann::json& object, const std::string& key,
                   const std::string& where);
const nlohmann::json& ListAt(const nlohmann::json& object,
                             const std::string& key, const std::string& where);
std::vector<std::string> TextsAt(const nlohmann::json& object,
                                 const std::string& key,
                                 const std::string& where);
/// @throws std::invalid_argument also for a number below `least`
int64_t NumberAt(const nlohmann::json& object, const std::string& key,
                 const std::string& where, int64_t least);

/// @param indent  -1: on one line
/// @throws std::invalid_argument for a text that is not UTF-8.
std::string Dump(const nlohmann::ordered_json& value, int indent);

}  // namespace cell::library
