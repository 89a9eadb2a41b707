#include "services/library/record_json.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "services/library/strict_json.h"

namespace cell::library {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

// The keys of texts, in the order of the struct.
struct TextKey {
  const char* key;
  std::string ActionRecord::*text;
};
constexpr std::array kTexts = {
    TextKey{"undoes", &ActionRecord::undoes},
    TextKey{"sec", &ActionRecord::sec},
    TextKey{"rules", &ActionRecord::rules},
    TextKey{"robot", &ActionRecord::robot},
    TextKey{"skill", &ActionRecord::skill},
    TextKey{"skill_settings", &ActionRecord::skill_settings}};

}  // namespace

ordered_json ToJson(const ActionRecord& record) {
  ordered_json object = {
      {"id", record.id}, {"version", record.version}, {"name", record.name}};
  object["arguments"] = ordered_json::array();
  for (const auto& [name, type] : record.arguments) {
    object["arguments"].push_back({{"name", name}, {"type", type}});
  }
  object["agents"] = record.agents;
  for (const TextKey& entry : kTexts) object[entry.key] = record.*entry.text;
  return object;
}

std::string JsonOf(const ActionRecord& record) {
  return Dump(ToJson(record), -1);
}

ActionRecord RecordFromJson(const json& object, const std::string& where) {
  std::vector<std::string_view> keys = {"id", "version", "name", "arguments",
                                        "agents"};
  for (const TextKey& entry : kTexts) keys.push_back(entry.key);
  RequireObject(object, where, keys);
  ActionRecord record;
  record.id = NumberAt(object, "id", where, 0);
  record.version = NumberAt(object, "version", where, 0);
  if (record.version < 1 || record.version > ActionRecord::kMaxVersion) {
    FailAt(where + ".version",
           fmt::format("is not 1 to {}", ActionRecord::kMaxVersion));
  }
  record.name = TextAt(object, "name", where);
  for (const json& item : ListAt(object, "arguments", where)) {
    const std::string place =
        fmt::format("{}.arguments[{}]", where, record.arguments.size());
    RequireObject(item, place, {"name", "type"});
    record.arguments.push_back(
        {TextAt(item, "name", place), TextAt(item, "type", place)});
  }
  record.agents = TextsAt(object, "agents", where);
  for (const TextKey& entry : kTexts) {
    record.*entry.text = TextAt(object, entry.key, where);
  }
  return record;
}

}  // namespace cell::library
