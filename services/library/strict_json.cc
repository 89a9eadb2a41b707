#include "services/library/strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

nlohmann::json ParseJson(const std::string& text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    const auto end = text.begin() +
                     static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    FailAt(fmt::format("{}:{}", file, 1 + std::count(text.begin(), end, '\n')),
           "is not JSON");
  } catch (const nlohmann::json::out_of_range&) {
    FailAt(file, "is not JSON: a number in it is too large");
  }
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
                 const std::string& where, int64_t least) {
  const nlohmann::json& value = EntryAt(object, key, where);
  constexpr uint64_t kMost = std::numeric_limits<int64_t>::max();
  const bool is_number =
      value.is_number_unsigned()
          ? value.get<uint64_t>() <= kMost &&
                static_cast<int64_t>(value.get<uint64_t>()) >= least
          : value.is_number_integer() && value.get<int64_t>() >= least;
  if (!is_number) {
    FailAt(where + "." + key,
           fmt::format("should be a whole number from {} on", least));
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
