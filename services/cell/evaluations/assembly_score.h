#pragma once

#include <set>
#include <string>
#include <vector>

#include "cell/truth_poses_t.hpp"
#include "common/parts/part_table.h"
#include "services/vtb/script.h"

namespace cell::cli {

/// What has been put together, by the ground truth over all parts: the one
/// place that says what success is. A site counts when a part of the right
/// type sits in it - depth, axis, turn within the rule's tolerances - and
/// rests: it has not moved between two looks.
struct AssemblyScore {
  std::vector<std::string> seated;   ///< sites, sorted
  std::vector<std::string> missing;  ///< sites, sorted
  std::set<std::string> placed;      ///< the parts that sit in `seated`

  bool is_complete() const { return missing.empty() && !seated.empty(); }
};

/// `earlier` and `now`: two looks at least 0.1 s apart.
/// @throws std::invalid_argument if not.
AssemblyScore ScoreAssembly(const truth_poses_t& earlier,
                            const truth_poses_t& now, const PartTable& parts,
                            const vtb::DemonstratorBook& book);

}  // namespace cell::cli
