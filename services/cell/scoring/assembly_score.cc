#include "services/cell/scoring/assembly_score.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "common/geometry/pose.h"
#include "common/relational/state.h"

namespace cell::cli {
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

bool IsAtRest(const std::string& part, const Poses& earlier, const Poses& now,
              double seconds) {
  const auto before = earlier.find(part);
  const auto after = now.find(part);
  return before != earlier.end() && after != now.end() &&
         (after->second.translation() - before->second.translation()).norm() <
             kStill * seconds;
}

bool IsInPlace(const GroundAtom& atom, const SuccessCriterion& success,
               const Poses& poses) {
  const Part& part = success.PartOf(atom);
  const Site& site = success.SiteOf(atom);
  const auto pose = poses.find(part.name);
  const auto host = poses.find(site.host);
  if (pose == poses.end() || host == poses.end() ||
      std::ranges::find(part.fits, site.type) == part.fits.end()) {
    return false;
  }
  return IsSeated((host->second * site.X_HS).inverse() * pose->second,
                  part.symmetry_order,
                  success.seats.at(atom.predicate).tolerance);
}

}  // namespace

AssemblyScore ScoreAssembly(const truth_poses_t& earlier,
                            const truth_poses_t& now,
                            const SuccessCriterion& success) {
  const int64_t elapsed = now.header.utime - earlier.header.utime;
  if (elapsed < kLeastUs) {
    throw std::invalid_argument("two snapshots " + std::to_string(elapsed) +
                                " us apart do not tell what is at rest");
  }
  const Poses before = PosesOf(earlier), after = PosesOf(now);
  State truth(success.vocabulary.num_atoms());
  AssemblyScore score;
  for (const Literal& literal : success.literals) {
    std::set<std::string> placed;
    for (const int index : Groundings(literal, {}, success.vocabulary)) {
      const GroundAtom atom = success.vocabulary.Atom(index);
      const std::string& part = success.PartOf(atom).name;
      const bool is_in_place = IsInPlace(atom, success, after);
      const bool is_at_rest =
          IsAtRest(part, before, after, 1e-6 * static_cast<double>(elapsed));
      // A moving part may still leave its site.
      truth.Set(index, !is_in_place ? Truth::kFalse
                       : is_at_rest ? Truth::kTrue
                                    : Truth::kUnknown);
      if (is_in_place && is_at_rest) placed.insert(part);
    }
    const bool holds = MustHold(literal, {}, truth, success.vocabulary);
    (holds ? score.seated : score.missing).push_back(success.NameOf(literal));
    if (holds) score.placed.merge(placed);
  }
  std::ranges::sort(score.seated);
  std::ranges::sort(score.missing);
  return score;
}

bool IsThreaded(const std::string& name, const PartTable& parts) {
  const Site* site = parts.FindSite(name);
  return site != nullptr && parts.FindThread(site->type) != nullptr;
}

}  // namespace cell::cli
