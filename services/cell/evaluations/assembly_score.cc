#include "services/cell/evaluations/assembly_score.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "common/geometry/pose.h"

namespace cell::cli {

using namespace vtb;
namespace {

using Eigen::Isometry3d;
using Poses = std::map<std::string, Isometry3d>;

constexpr int64_t kLeastUs = 100'000;
constexpr double kStill = 0.002;  // [m/s]

Poses PosesOf(const truth_poses_t& message) {
  Poses poses;
  for (const body_pose_t& body : message.bodies) {
    if (const auto X_WB = PoseFromMessage(body.pose_world_body)) {
      poses[body.name] = *X_WB;
    }
  }
  return poses;
}

// A part of the rule's type that sits in the site, or nullptr.
const Part* PartIn(const Site& site, const PlacementRule& rule,
                   const PartTable& parts, const Poses& poses) {
  const auto host = poses.find(site.host);
  if (host == poses.end()) return nullptr;
  const Isometry3d X_SW = (host->second * site.X_HS).inverse();
  for (const Part& part : parts.parts()) {
    const auto pose = poses.find(part.name);
    if (part.type != rule.part_type || pose == poses.end()) continue;
    if (IsSeated(X_SW * pose->second, part.symmetry_order, rule.seated)) {
      return &part;
    }
  }
  return nullptr;
}

bool IsAtRest(const std::string& part, const Poses& earlier, const Poses& now,
              double seconds) {
  const auto before = earlier.find(part);
  const auto after = now.find(part);
  return before != earlier.end() && after != now.end() &&
         (after->second.translation() - before->second.translation()).norm() <
             kStill * seconds;
}

}  // namespace

AssemblyScore ScoreAssembly(const truth_poses_t& earlier,
                            const truth_poses_t& now, const PartTable& parts,
                            const DemonstratorBook& book) {
  const int64_t elapsed = now.header.utime - earlier.header.utime;
  if (elapsed < kLeastUs) {
    throw std::invalid_argument("two looks " + std::to_string(elapsed) +
                                " us apart do not tell who rests");
  }
  const Poses before = PosesOf(earlier), after = PosesOf(now);
  AssemblyScore score;
  for (const auto& [name, rule] : book.rules) {
    for (const Part& host : parts.parts()) {
      for (const Site& site : host.sites) {
        if (site.type != rule.site_type) continue;
        const Part* part = PartIn(site, rule, parts, after);
        const bool is_seated =
            part != nullptr && IsAtRest(part->name, before, after,
                                        1e-6 * static_cast<double>(elapsed));
        (is_seated ? score.seated : score.missing).push_back(site.name);
        if (is_seated) score.placed.insert(part->name);
      }
    }
  }
  std::ranges::sort(score.seated);
  std::ranges::sort(score.missing);
  return score;
}

}  // namespace cell::cli
