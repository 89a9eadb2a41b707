#include "services/robot_arm/fastening.h"

#include <algorithm>

#include "common/geometry/degree.h"
#include "common/predicates/seat.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;

/// Wider than what counts as placed: from here a part that is let go of comes
/// to rest in its seat.
constexpr SeatTolerance kSeated{0.002, 0.0045, 2 * kDegree, 10 * kDegree};
/// As a thread takes hold, and somewhat more: to let go of what a thread does
/// not hold yet does no harm, to pull at what it holds does.
constexpr double kThreadMargin = 1.5;
constexpr double kThreadHeight = 0.0005;  // [m]

bool IsOnThread(const Isometry3d& X_SO, const Thread& thread) {
  const SeatTolerance tolerance{0, kThreadMargin * thread.max_offset,
                                kThreadMargin * thread.max_tilt, 0};
  Isometry3d level = X_SO;
  level.translation().z() = 0;
  const double height = X_SO.translation().z();
  return height >= -kSeated.z && height <= thread.engagement + kThreadHeight &&
         IsSeated(level, 0, tolerance);
}

}  // namespace

const Site* FindHoldingSite(const std::string& name, const PartTable& parts,
                            const std::map<std::string, Isometry3d>& poses) {
  const Part* part = parts.Find(name);
  const auto pose = poses.find(name);
  if (part == nullptr || pose == poses.end()) return nullptr;
  for (const auto& [host_name, X_WH] : poses) {
    const Part* host = parts.Find(host_name);
    if (host == nullptr) continue;
    for (const Site& site : host->sites) {
      if (std::ranges::find(part->fits, site.type) == part->fits.end()) {
        continue;
      }
      const Isometry3d X_SO = (X_WH * site.X_HS).inverse() * pose->second;
      const Thread* thread = parts.FindThread(site.type);
      const bool is_held = thread != nullptr
                               ? IsOnThread(X_SO, *thread)
                               : IsSeated(X_SO, part->symmetry_order, kSeated);
      if (is_held) return &site;
    }
  }
  return nullptr;
}

}  // namespace cell::robot_arm
