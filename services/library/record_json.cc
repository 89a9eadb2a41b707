#include "services/library/record_json.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "common/actions/build_version.h"

namespace cell::library {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr char kFormat[] = "actions of a cell";
// In 1 records have no version; in 1 and 2 the content does not name the build.
constexpr int kVersion = 3;

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

std::string Dump(const ordered_json& value, int indent) {
  try {
    return value.dump(indent);
  } catch (const ordered_json::type_error&) {
    throw std::invalid_argument("is not UTF-8");
  }
}

[[noreturn]] void Fail(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

const json& Entry(const json& object, const std::string& key,
                  const std::string& where) {
  const auto it = object.find(key);
  if (it == object.end()) Fail(where + "." + key, "missing");
  return *it;
}

void RequireObject(const json& value, const std::string& where,
                   const std::vector<std::string_view>& keys) {
  if (!value.is_object()) Fail(where, "should be an object");
  for (const auto& item : value.items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
      Fail(where + "." + item.key(),
           "not known; remove it or correct its name");
    }
  }
}

std::string TextAt(const json& object, const std::string& key,
                   const std::string& where) {
  const json& value = Entry(object, key, where);
  if (!value.is_string()) Fail(where + "." + key, "should be text");
  return value.get<std::string>();
}

const json& ListAt(const json& object, const std::string& key,
                   const std::string& where) {
  const json& value = Entry(object, key, where);
  if (!value.is_array()) Fail(where + "." + key, "should be a list");
  return value;
}

int64_t NumberAt(const json& object, const std::string& key,
                 const std::string& where) {
  const json& value = Entry(object, key, where);
  if (!value.is_number_integer()) {
    Fail(where + "." + key, "should be a whole number");
  }
  return value.get<int64_t>();
}

}  // namespace

std::string JsonOf(const ActionRecord& record) {
  return Dump(ToJson(record), -1);
}

ActionRecord RecordFromJson(const json& object, const std::string& where) {
  std::vector<std::string_view> keys = {"id", "version", "name", "arguments",
                                        "agents"};
  for (const TextKey& entry : kTexts) keys.push_back(entry.key);
  RequireObject(object, where, keys);
  ActionRecord record;
  record.id = NumberAt(object, "id", where);
  record.version = NumberAt(object, "version", where);
  if (record.version < 1 || record.version > ActionRecord::kMaxVersion) {
    Fail(where + ".version",
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
  for (const json& item : ListAt(object, "agents", where)) {
    if (!item.is_string()) Fail(where + ".agents", "should be a list of texts");
    record.agents.push_back(item.get<std::string>());
  }
  for (const TextKey& entry : kTexts) {
    record.*entry.text = TextAt(object, entry.key, where);
  }
  return record;
}

std::string TextOfContent(const std::vector<ActionRecord>& records) {
  ordered_json content = {
      {"format", kFormat}, {"version", kVersion}, {"build", BuildVersion()}};
  content["actions"] = ordered_json::array();
  for (const ActionRecord& record : records) {
    content["actions"].push_back(ToJson(record));
  }
  return Dump(content, 1) + "\n";
}

std::vector<ActionRecord> ContentFromText(const std::string& text,
                                          const std::string& file) {
  const json content = json::parse(text, nullptr, false);
  if (content.is_discarded()) Fail(file, "is not JSON");
  if (!content.is_object()) Fail(file, "should be an object");
  if (TextAt(content, "format", file) != kFormat) {
    Fail(file + ".format", fmt::format("should be '{}'", kFormat));
  }
  const int64_t version = NumberAt(content, "version", file);
  if (version < 1 || version > kVersion) {
    const auto build = content.find("build");
    Fail(file + ".version",
         fmt::format("is {}; this build ({}) reads 1 to {}; use {}, or a newer "
                     "one",
                     version, BuildVersion(), kVersion,
                     build != content.end() && build->is_string()
                         ? "build " + build->get<std::string>()
                         : "the build of the cell that wrote it"));
  }
  RequireObject(content, file, {"format", "version", "build", "actions"});
  if (version >= 3) TextAt(content, "build", file);
  std::vector<ActionRecord> records;
  for (json item : ListAt(content, "actions", file)) {
    if (version == 1 && item.is_object()) item["version"] = 1;
    records.push_back(RecordFromJson(
        item, fmt::format("{}:actions[{}]", file, records.size())));
  }
  return records;
}

}  // namespace cell::library
