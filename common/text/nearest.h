#pragma once

#include <functional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace cell {

/// The names that `name_of` returns, in the order of the range.
template <std::ranges::input_range Range, class NameOf = std::identity>
std::vector<std::string> NamesIn(const Range& range, NameOf name_of = {}) {
  std::vector<std::string> names;
  for (const auto& element : range) {
    names.emplace_back(std::invoke(name_of, element));
  }
  return names;
}

/// The names that a map's entries go by, in its order.
template <class Map>
std::vector<std::string> KeysOf(const Map& map) {
  return NamesIn(map, &Map::value_type::first);
}

/// The one of `names` that `name` was probably meant to be: the fewest letters
/// to add, drop, change or swap, at most a third of them; empty if none is so
/// near. Of several the first.
std::string NearestOf(std::string_view name,
                      const std::vector<std::string>& names);

/// What follows an error about the unknown `name`: "; did you mean 'assembly'?
/// Known: assembly, execution".
std::string NamesInstead(std::string_view name,
                         const std::vector<std::string>& names);

}  // namespace cell
