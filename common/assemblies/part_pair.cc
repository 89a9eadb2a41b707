#include "common/assemblies/part_pair.h"

#include <algorithm>
#include <utility>

namespace cell::assemblies {

std::string NormalisedName(std::string_view name) {
  std::string normal;
  bool is_gap = false;
  for (const char c : name) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    const char small = is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    if ((small >= 'a' && small <= 'z') || (small >= '0' && small <= '9')) {
      if (is_gap && !normal.empty()) normal += '_';
      normal += small;
      is_gap = false;
    } else {
      is_gap = true;
    }
  }
  const bool begins_with_digit = !normal.empty() && normal[0] <= '9';
  return begins_with_digit ? "part_" + normal : normal;
}

PartPair MakePair(std::string_view a, std::string_view b) {
  PartPair pair{NormalisedName(a), NormalisedName(b)};
  if (pair.second < pair.first) std::swap(pair.first, pair.second);
  return pair;
}

std::string Show(const PartPair& pair) {
  std::string text = pair.first + " - " + pair.second;
  std::ranges::replace(text, '_', ' ');
  return text;
}

}  // namespace cell::assemblies
