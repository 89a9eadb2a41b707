#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/config/deployment.h"
#include "common/parts/part_table.h"
#include "common/predicates/seat.h"
#include "common/relational/domain.h"

namespace cell::cli {

/// The criterion of a task's success: the literals of a goal, judged on the
/// ground truth by tolerances of their own; success.yaml of the task.
///
///   goal: assembled            # of domain.yaml
///   seated:                    # each predicate of the goal's literals
///     InHole: {z_mm, xy_mm, tilt_deg, yaw_deg}
///     LidPlaced: {site: box.lid, z_mm, xy_mm, tilt_deg, yaw_deg}
/// says that the first argument, a part, sits at the second one, or at `site`.
struct SuccessCriterion {
  /// What a predicate means.
  struct Seat {
    SeatTolerance tolerance;
    std::optional<std::string> site;  ///< nothing: the second argument
  };

  PartTable parts;
  Vocabulary vocabulary;
  std::vector<Literal> literals;
  std::map<int, Seat> seats;  ///< of each predicate of the literals

  /// @throws ConfigError naming file:key for a goal, predicate or site that is
  /// not there, arguments that are no part and site, and a predicate of the
  /// goal that is left out.
  static SuccessCriterion FromConfig(const Config& config, const Domain& domain,
                                     const PartTable& parts);
  static SuccessCriterion Load(const Deployment& deployment);
  /// The same for another goal of the domain.
  /// @throws std::invalid_argument for a literal that no seat is known for.
  SuccessCriterion ForGoal(const Goal& goal) const;

  /// The part and the site of an atom of one of the predicates.
  const Part& PartOf(const GroundAtom& atom) const;
  const Site& SiteOf(const GroundAtom& atom) const;
  /// Where the literal wants a part; its text if that is at any site.
  std::string NameOf(const Literal& literal) const;
};

}  // namespace cell::cli
