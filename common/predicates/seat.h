#pragma once

#include <Eigen/Geometry>

#include "common/config/config.h"
#include "common/relational/state.h"

namespace cell {

/// How near to its site a part must be to count as seated. SI units.
struct SeatTolerance {
  double z = 0;     ///< [m] either way along z of the site
  double xy = 0;    ///< [m] sideways
  double tilt = 0;  ///< [rad] between the z axes
  double yaw = 0;   ///< [rad] about z, up to the part's symmetry

  /// Reads z_mm, xy_mm, tilt_deg, yaw_deg.
  static SeatTolerance FromConfig(const Config& config);
};

/// True if the part's frame O coincides with the site's frame S up to the
/// part's symmetry (0: any rotation about z, else n-fold) and the tolerance.
bool IsSeated(const Eigen::Isometry3d& X_SO, int symmetry_order,
              const SeatTolerance& tolerance);

/// How far a pose may be from the truth, as far as can be told. SI units.
struct PoseUncertainty {
  double position = 0;  ///< [m] of each coordinate
  double rotation = 0;  ///< [rad] about each axis

  /// Of key frames that are made of tracks with this noise: three standard
  /// deviations, as what has just come to rest may hardly be smoothed.
  static PoseUncertainty OfKeyFrames(double position_sd, double rotation_sd) {
    return {3 * position_sd, 3 * rotation_sd};
  }
};

/// IsSeated() of all poses that X_SO may stand for: unknown if it depends.
Truth SeatedTruth(const Eigen::Isometry3d& X_SO, int symmetry_order,
                  const SeatTolerance& tolerance,
                  const PoseUncertainty& uncertainty);

/// [rad] Rotation from A to B, of two frames of one part, that can be seen:
/// the least of all that differ by a rotation which leaves the part as it is.
double VisibleAngle(const Eigen::Isometry3d& X_AB, int symmetry_order);

/// [rad] Between the axis z of a frame and the vertical, 0 to pi/2.
double TiltOf(const Eigen::Isometry3d& X_WO);

}  // namespace cell
