#include "services/cell/evaluations/row_shape.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace cell::cli {

using nlohmann::json;
namespace {

constexpr size_t kMostCharacters = 40;  // characters of a value

std::string TextOf(const RowShape& shape) {
  switch (shape.kind) {
    case RowShape::kFlag:
      return "true or false";
    case RowShape::kWhole:
      return "a whole number of at most 32 bits";
    case RowShape::kSeed:
      return "a whole number from 0 on of at most 64 bits";
    case RowShape::kNumber:
      return "a number";
    case RowShape::kText:
      return "a text";
    case RowShape::kList:
      return shape.length ? fmt::format("a list of {}", *shape.length)
                          : "a list";
    case RowShape::kMap:
    case RowShape::kRecord:
      return "an object";
  }
  return "";
}

bool IsWhole(const json& value) {
  if (value.is_number_unsigned()) {
    return value.get<uint64_t>() <=
           static_cast<uint64_t>(std::numeric_limits<int>::max());
  }
  return value.is_number_integer() &&
         value.get<int64_t>() >= std::numeric_limits<int>::min() &&
         value.get<int64_t>() <= std::numeric_limits<int>::max();
}

/// Leaves out what is in it.
bool IsOfKind(const json& value, const RowShape& shape) {
  switch (shape.kind) {
    case RowShape::kFlag:
      return value.is_boolean();
    case RowShape::kWhole:
      return IsWhole(value);
    case RowShape::kSeed:
      return value.is_number_integer() &&
             (value.is_number_unsigned() || value.get<int64_t>() >= 0);
    case RowShape::kNumber:
      return value.is_number();
    case RowShape::kText:
      return value.is_string();
    case RowShape::kList:
      return value.is_array() &&
             value.size() == shape.length.value_or(value.size());
    case RowShape::kMap:
    case RowShape::kRecord:
      return value.is_object();
  }
  return false;
}

std::string Shown(const json& value) {
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_object()) return "an object";
  const std::string text = value.dump(-1, ' ', true);
  return text.size() <= kMostCharacters
             ? text
             : text.substr(0, kMostCharacters) + "...";
}

std::string NameOfField(const std::string& where, const std::string& name) {
  return where.empty() ? name : where + "." + name;
}

std::optional<std::string> MisfitAt(const std::string& where, const json& value,
                                    const RowShape& shape) {
  if (!IsOfKind(value, shape)) {
    return fmt::format("{}should be {}, is {}",
                       where.empty() ? "" : where + ": ", TextOf(shape),
                       Shown(value));
  }
  for (const auto& [name, of_field] : shape.fields) {
    const std::string field = NameOfField(where, name);
    if (!value.contains(name)) {
      return fmt::format("{}: is missing, should be {}", field,
                         TextOf(of_field));
    }
    if (auto misfit = MisfitAt(field, value.at(name), of_field)) return misfit;
  }
  for (const RowShape& each : shape.each) {
    for (const auto& [name, element] : value.items()) {
      const std::string at = value.is_array()
                                 ? fmt::format("{}[{}]", where, name)
                                 : NameOfField(where, name);
      if (auto misfit = MisfitAt(at, element, each)) return misfit;
    }
  }
  return std::nullopt;
}

}  // namespace

RowShape RowShape::ListOf(const RowShape& each, std::optional<size_t> length) {
  RowShape shape(kList);
  shape.each = {each};
  shape.length = length;
  return shape;
}

RowShape RowShape::MapOf(const RowShape& each) {
  RowShape shape(kMap);
  shape.each = {each};
  return shape;
}

RowShape RowShape::Record(Fields fields) {
  RowShape shape(kRecord);
  shape.fields = std::move(fields);
  return shape;
}

RowShape RowShape::Counts(const std::vector<std::string>& names) {
  RowShape shape(kRecord);
  for (const std::string& name : names) shape.fields.emplace(name, kWhole);
  return shape;
}

RowShape RowShape::With(const Fields& more) const {
  RowShape shape = *this;
  shape.fields.insert(more.begin(), more.end());
  return shape;
}

std::optional<std::string> MisfitOf(const json& value, const RowShape& shape) {
  return MisfitAt("", value, shape);
}

}  // namespace cell::cli
