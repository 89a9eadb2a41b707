#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/parts/part_joint.h"
#include "common/parts/piece.h"

namespace cell {

/// Where a part belongs on another one: the frame S that the part's frame O
/// coincides with when it is seated. It is inserted along -z of S.
struct Site {
  std::string name;  ///< "<part>.<site>"
  std::string type;  ///< what may go there, e.g. a kind of hole
  std::string host;  ///< part
  Eigen::Isometry3d X_HS = Eigen::Isometry3d::Identity();
  double approach = 0;  ///< [m] along z of S, from where the way in is straight
  double opening = 0;   ///< [m] radius of the free column that the way in needs
  double depth = 0;     ///< [m] from the site's mouth to its floor
};

/// How a hand takes a part: gripper frame G (approach along -z, fingers close
/// along x).
struct Grasp {
  Eigen::Isometry3d X_OG = Eigen::Isometry3d::Identity();
  double width = 0;  ///< [m] between the fingers
  /// Grips of a hand (HandType) that suit it, the best first.
  std::vector<std::string> grips = {"two_finger_pinch"};
};

/// A right-hand thread: the last way of a part into a site of this type is by
/// turning it, clockwise seen along -z of S.
struct Thread {
  std::string site_type;
  double pitch = 0;       ///< [m] per turn
  double engagement = 0;  ///< [m] the thread takes hold from here on
  double max_offset = 0;  ///< [m] of the axes, to take hold
  double max_tilt = 0;    ///< [rad] of the axes, to take hold
};

/// One part of a task: a row of parts.yaml.
struct Part {
  std::string name;
  std::string type;               ///< of the task's domain
  std::vector<std::string> fits;  ///< site types it may be seated at
  std::vector<Piece> pieces;
  std::vector<Site> sites;
  std::vector<Grasp> grasps;  ///< of an articulated part: its handle
  /// Rotations about z of O that leave it as it is: 0 any angle, else n-fold.
  int symmetry_order = 1;
  bool is_fixed = false;           ///< clamped to the pedestal
  std::optional<PartJoint> joint;  ///< of an articulated part
  double density = 0;              ///< [kg/m^3]
  std::array<double, 3> colour{};  ///< 0..1

  /// Nothing holds it where it is.
  bool is_free() const { return !is_fixed && !joint; }
};

/// All parts of a task.
class PartTable {
 public:
  /// @throws ConfigError naming file:key for unknown or missing keys and for
  /// impossible parts (no volume, not convex, unknown type, duplicate names).
  static PartTable FromConfig(const Config& config);

  const std::vector<Part>& parts() const { return parts_; }
  /// Nothing if there is none of that name.
  const Part* Find(const std::string& name) const;
  const Site* FindSite(const std::string& name) const;
  /// Nothing if parts go into sites of that type without turning.
  const Thread* FindThread(const std::string& site_type) const;
  /// Pairs of contact classes that collide; "table" is the table's and the
  /// pedestal's.
  const std::vector<std::array<std::string, 2>>& contacts() const {
    return contacts_;
  }
  const std::vector<Thread>& threads() const { return threads_; }

 private:
  std::vector<Part> parts_;
  std::vector<std::array<std::string, 2>> contacts_;
  std::vector<Thread> threads_;
};

}  // namespace cell
