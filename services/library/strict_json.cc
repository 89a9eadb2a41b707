#include "services/library/strict_json.h"

#include <algorithm>
#include <stdexcept>

namespace cell::library {
namespace {

const nlohmann::json& EntryAt(const nlohmann::json& object,
                              const std::string& key,
                              const std::string& where) {
  const auto it = object.find(key);
  if (it == object.end()) FailAt(where + "." + key, "missing");
  return *it;
}

}  // namespace

void FailAt(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

void RequireObject(const nlohmann::json& value, const std::string& where,
                   const std::vector<std::string_view>& keys) {
  if (!value.is_object()) FailAt(where, "should be an object");
  for (const auto& item : value.items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
      FailAt(where + "." + item.key(),
             "not known; remove it or correct its name");
    }
  }
}

std::string TextAt(const nlohmann::json& object, const std::string& key,
                   const std::string& where) {
  const nlohmann::json& value = EntryAt(object, key, where);
  if (!value.is_string()) FailAt(where + "." + key, "should be text");
  return value.get<std::string>();
}

const nlohmann::json& ListAt(const nlohmann::json& object,
                             const std::string& key, const std::string& where) {
  const nlohmann::json& value = EntryAt(object, key, where);
  if (!value.is_array()) FailAt(where + "." + key, "should be a list");
  return value;
}

std::vector<std::string> TextsAt(const nlohmann::json& object,
                                 const std::string& key,
                                 const std::string& where) {
  std::vector<std::string> texts;
  for (const nlohmann::json& item : ListAt(object, key, where)) {
    if (!item.is_string()) {
      FailAt(where + "." + key, "should be a list of texts");
    }
    texts.push_back(item.get<std::string>());
  }
  return texts;
}

int64_t NumberAt(const nlohmann::json& object, const std::string& key,
                 const std::string& where) {
  const nlohmann::json& value = EntryAt(object, key, where);
  if (!value.is_number_integer()) {
    FailAt(where + "." + key, "should be a whole number");
  }
  return value.get<int64_t>();
}

std::string Dump(const nlohmann::ordered_json& value, int indent) {
  try {
    return value.dump(indent);
  } catch (const nlohmann::ordered_json::type_error&) {
    throw std::invalid_argument("is not UTF-8");
  }
}

}  // namespace cell::library
