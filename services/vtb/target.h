#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// Where a part is to go: a site, or a pose on the table.
struct Target {
  const PlacementRule* rule = nullptr;  ///< null: the table
  std::string site;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< of the table's
  /// [rad] to tip it on the table, about the axis between the fingers; then it
  /// is let go as low as it can be and falls.
  double tilt = 0;
  /// Of an attempt: where on the table the part goes if it does not seat at the
  /// site at the first try.
  std::optional<Eigen::Isometry3d> X_WO_else = std::nullopt;
};

/// How a hand goes for a target: chosen when it sets out.
struct Aim {
  /// Of the rotations that leave the part as it is.
  Eigen::Matrix3d symmetry = Eigen::Matrix3d::Identity();
  Eigen::Vector3d error = Eigen::Vector3d::Zero();     ///< [m] in S
  Eigen::Vector3d way_out = Eigen::Vector3d::UnitZ();  ///< unit, in W
  /// Of a target on the table, tipped as it is to be.
  Eigen::Isometry3d X_WO_table = Eigen::Isometry3d::Identity();
};

Eigen::Isometry3d PoseOfSite(const std::string& site, const World& world);
/// Nothing if parts go into the site without turning.
const Thread* ThreadOf(const std::string& site, const World& world);
/// Parts of its type go to such sites. Another one may drop into a site that is
/// too wide for it.
bool IsMeantFor(const std::string& part, const std::string& site,
                const World& world);
/// Where the part is to be, as the hand aims.
Eigen::Isometry3d GoalOf(const Target& target, const Aim& aim,
                         const World& world);

}  // namespace cell::vtb
