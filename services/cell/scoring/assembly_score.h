#pragma once

#include <set>
#include <string>
#include <vector>

#include "cell/truth_poses_t.hpp"
#include "services/cell/scoring/success_criterion.h"

namespace cell::cli {

/// What is assembled, by the ground truth of all parts: the one definition of
/// success. A literal of the goal counts when the part sits in its site -
/// depth, axis, turn within the criterion's tolerances - and rests: it has not
/// moved between two snapshots.
struct AssemblyScore {
  std::vector<std::string> seated;   ///< sites, sorted
  std::vector<std::string> missing;  ///< sites, sorted
  std::set<std::string> placed;      ///< the parts that sit in `seated`

  bool is_complete() const { return missing.empty() && !seated.empty(); }
};

/// `earlier` and `now`: two snapshots at least 0.1 s apart.
/// @throws std::invalid_argument if not.
AssemblyScore ScoreAssembly(const truth_poses_t& earlier,
                            const truth_poses_t& now,
                            const SuccessCriterion& success);

/// True if the last way into a site of a score is by turning.
bool IsThreaded(const std::string& site, const PartTable& parts);

}  // namespace cell::cli
