#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "common/geometry/part_shape.h"
#include "common/parts/part_table.h"
#include "common/predicates/clearance_column.h"
#include "common/predicates/seat.h"
#include "common/relational/vocabulary.h"

namespace cell {

/// What the predicates of a domain mean in space: their `geometry` blocks.

/// seated: {z_mm, xy_mm, tilt_deg, yaw_deg, site, touch}
/// The first argument is at its site - the second, or `site` - and touches its
/// host; with `touch: any` some part, if it is others that hold it up there.
struct SeatedGeometry {
  SeatTolerance tolerance;
  std::optional<Site> site;     ///< nothing: the second argument
  bool must_touch_host = true;  ///< else: some part
};

/// tilted: {over_deg}
/// Axis z of the argument lies further than that from the vertical.
struct TiltedGeometry {
  double over = 0;  ///< [rad]
};

/// graspable: {finger_mm, above_mm}
/// The argument is within the workspace, nothing rests on it, and above the
/// fingertips of some grasp columns of this radius and height are free of what
/// lies over it. In a hand it is graspable anyway.
struct GraspableGeometry {
  double finger = 0;       ///< [m] radius
  ClearanceColumn column;  ///< up from a fingertip
};

/// free_space: {above_mm}
/// Nothing is in the argument's column: as wide as the site's `opening`, from
/// its floor to `above_mm` above its mouth.
struct FreeSpaceGeometry {
  std::vector<ClearanceColumn>
      columns;  ///< in S, of each object of the argument's type
};

/// Not decided by geometry: the arms report it.
struct ReportedGeometry {};

using PredicateGeometry =
    std::variant<SeatedGeometry, TiltedGeometry, GraspableGeometry,
                 FreeSpaceGeometry, ReportedGeometry>;

/// Reads the `geometry` of each predicate of a domain.
/// @throws ConfigError for a sensed predicate without a block, of more than one
/// kind, or with arguments that do not suit it.
std::vector<PredicateGeometry> ReadGeometries(const Config& domain,
                                              const Vocabulary& vocabulary,
                                              const PartTable& parts);

}  // namespace cell
