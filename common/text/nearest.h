#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cell {

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
