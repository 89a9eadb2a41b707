#include "common/sec/role_matching.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace cell {

void ForEachMatching(size_t num_roles, size_t num_places,
                     const std::function<void(const RoleMap&)>& visit) {
  if (num_roles == 0 || num_places == 0 || num_roles < num_places) return;
  std::vector<size_t> others(num_roles - 1);
  std::iota(others.begin(), others.end(), size_t{1});
  do {
    // Of orders that differ behind the last place one is enough.
    if (!std::is_sorted(
            others.begin() + static_cast<std::ptrdiff_t>(num_places - 1),
            others.end())) {
      continue;
    }
    RoleMap places(num_roles);
    places[0] = 0;
    for (size_t place = 1; place < num_places; ++place) {
      places[others[place - 1]] = place;
    }
    visit(places);
  } while (std::next_permutation(others.begin(), others.end()));
}

}  // namespace cell
