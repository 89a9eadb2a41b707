#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cell::cli {

/// What a value of a row has to be, so that it can be read without a doubt.
struct RowShape {
  enum Kind {
    kFlag,    ///< true or false
    kWhole,   ///< fits in an int
    kSeed,    ///< whole, not negative, fits in 64 bits
    kNumber,  ///< any
    kText,
    kList,    ///< of `each`, of `length` of them if that is given
    kMap,     ///< of `each`, by any name
    kRecord,  ///< with at least `fields`
  };
  using Fields = std::map<std::string, RowShape>;

  RowShape(Kind kind_of_value) : kind(kind_of_value) {}  // NOLINT: {"a", kText}
  static RowShape ListOf(const RowShape& each,
                         std::optional<size_t> length = std::nullopt);
  static RowShape MapOf(const RowShape& each);
  static RowShape Record(Fields fields);
  /// A record with these whole numbers.
  static RowShape Counts(const std::vector<std::string>& names);
  /// A record that has these fields, too.
  RowShape With(const Fields& more) const;

  Kind kind;
  std::vector<RowShape> each;  // one, or none
  std::optional<size_t> length;
  Fields fields;
};

/// Nothing if the value has the shape, else where it has not and what would be
/// right: "stops[2].kind: should be a text, is 7".
std::optional<std::string> MisfitOf(const nlohmann::json& value,
                                    const RowShape& shape);

}  // namespace cell::cli
