#include "services/vtb/target.h"

#include <algorithm>
#include <vector>

namespace cell::vtb {

using Eigen::Isometry3d;

Isometry3d PoseOfSite(const std::string& name, const World& world) {
  const Site& site = *world.table().FindSite(name);
  return world.PoseOf(site.host) * site.X_HS;
}

const Thread* ThreadOf(const std::string& site, const World& world) {
  return world.table().FindThread(world.table().FindSite(site)->type);
}

bool IsMeantFor(const std::string& part, const std::string& site,
                const World& world) {
  const std::vector<std::string>& fits = world.table().Find(part)->fits;
  return std::ranges::count(fits, world.table().FindSite(site)->type) > 0;
}

Isometry3d GoalOf(const Target& target, const Aim& aim, const World& world) {
  if (target.rule == nullptr) return aim.X_WO_table;
  return PoseOfSite(target.site, world) *
         Eigen::Translation3d(target.rule->aim + aim.error) *
         Isometry3d(Eigen::Quaterniond(aim.symmetry));
}

}  // namespace cell::vtb
