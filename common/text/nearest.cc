#include "common/text/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace cell {
namespace {

/// Optimal string alignment: a swap of two neighbours counts as one change.
size_t NumChanges(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> d(a.size() + 1,
                                     std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string NearestOf(std::string_view name,
                      const std::vector<std::string>& names) {
  constexpr size_t kMaxLength = 100;  // of a mistyped name
  if (name.size() > kMaxLength) return {};
  std::string nearest;
  size_t fewest = std::max<size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const size_t num = NumChanges(name, candidate);
    if (num >= fewest) continue;
    fewest = num;
    nearest = candidate;
  }
  return nearest;
}

std::string NamesInstead(std::string_view name,
                         const std::vector<std::string>& names) {
  const std::string nearest = NearestOf(name, names);
  const std::string all =
      names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
  if (nearest.empty()) return "; known: " + all;
  return fmt::format("; did you mean '{}'? Known: {}", nearest, all);
}

}  // namespace cell
