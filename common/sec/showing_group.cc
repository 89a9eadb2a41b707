#include "common/sec/showing_group.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <utility>

namespace cell {
namespace {

/// What both share, as if it had been taught by one. @pre of the same roles.
Contribution Common(const Contribution& a, const Contribution& b,
                    const TypeHierarchy& hierarchy) {
  Contribution common{a.shown,
                      b.build,
                      a.types,
                      Intersection(a.pick, b.pick),
                      Intersection(a.place, b.place),
                      a.chain};
  for (const auto& [source, count] : b.shown) common.shown[source] += count;
  for (size_t role = 0; role < common.types.size(); ++role) {
    common.types[role] = CommonType(hierarchy, a.types[role], b.types[role]);
  }
  return common;
}

Contribution Reversed(const Contribution& contribution) {
  const Showing read = Showing{{},
                               contribution.types,
                               contribution.pick,
                               contribution.place,
                               contribution.chain}
                           .Reversed();
  return {contribution.shown, contribution.build, read.types,
          read.pick,          read.place,         read.chain};
}

bool IsOf(const Contribution& contribution, const std::string& demonstration) {
  return contribution.shown.size() == 1 &&
         contribution.shown.contains(demonstration);
}

}  // namespace

std::map<std::string, int> ShowingGroup::Shown() const {
  std::map<std::string, int> shown;
  for (const Contribution& contribution : taught) {
    for (const auto& [source, count] : contribution.shown) {
      shown[source] += count;
    }
  }
  return shown;
}

Showing ShowingGroup::AsShowing() const {
  return {{}, types, pick, place, chain};
}

void ShowingGroup::Add(Contribution contribution,
                       const TypeHierarchy& hierarchy) {
  const auto known = std::ranges::find_if(taught, [&](const auto& other) {
    return std::ranges::equal(other.shown | std::views::keys,
                              contribution.shown | std::views::keys);
  });
  if (known != taught.end()) {
    *known = Common(*known, contribution, hierarchy);
  } else {
    taught.push_back(std::move(contribution));
  }
  if (taught.size() > kMaxTaught) {
    taught[1] = Common(taught[0], taught[1], hierarchy);
    taught.erase(taught.begin());
  }
  Share(hierarchy);
}

void ShowingGroup::Absorb(const ShowingGroup& other, const RoleMap& places,
                          const TypeHierarchy& hierarchy) {
  for (const Contribution& contribution : other.taught) {
    Add(cell::Renamed(contribution, places), hierarchy);
  }
}

void ShowingGroup::Widen(const std::vector<int>& wider,
                         const TypeHierarchy& hierarchy) {
  least_types = wider;
  Share(hierarchy);
}

Result<bool> ShowingGroup::TakeBack(const std::string& demonstration,
                                    const TypeHierarchy& hierarchy) {
  const auto found = std::ranges::find_if(taught, [&](const auto& known) {
    return known.shown.contains(demonstration);
  });
  if (found == taught.end()) return false;
  if (!IsOf(*found, demonstration)) {
    return Reason{
        fmt::format("what '{}' has taught {} is only known together with: {}",
                    demonstration, name,
                    fmt::join(found->shown | std::views::keys |
                                  std::views::filter([&](const auto& s) {
                                    return s != demonstration;
                                  }),
                              ", "))};
  }
  taught.erase(found);
  Share(hierarchy);
  return true;
}

void ShowingGroup::Share(const TypeHierarchy& hierarchy) {
  std::optional<Contribution> all;
  for (const Contribution& contribution : taught) {
    all = all ? Common(*all, contribution, hierarchy) : contribution;
  }
  if (!all) all.emplace();
  types = all->types;
  if (types.size() == least_types.size()) {
    for (size_t i = 0; i < types.size(); ++i) {
      types[i] = CommonType(hierarchy, types[i], least_types[i]);
    }
  }
  pick = all->pick;
  place = all->place;
  chain = all->chain;
}

Contribution ContributionOf(const Showing& showing, const RoleMap& places,
                            size_t num_roles, const std::string& source,
                            const std::string& build) {
  Contribution contribution{{{source, 1}},
                            build,
                            std::vector<int>(num_roles),
                            Renamed(showing.pick, places),
                            Renamed(showing.place, places),
                            showing.chain};
  for (size_t role = 0; role < places.size(); ++role) {
    if (places[role]) contribution.types[*places[role]] = showing.types[role];
  }
  return contribution;
}

ShowingGroup Reversed(const ShowingGroup& group) {
  ShowingGroup reversed = group;
  for (Contribution& contribution : reversed.taught) {
    contribution = Reversed(contribution);
  }
  const Showing read = group.AsShowing().Reversed();
  reversed.pick = read.pick;
  reversed.place = read.place;
  reversed.chain = read.chain;
  return reversed;
}

}  // namespace cell
