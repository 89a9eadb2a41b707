#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell::vtb {

/// What a part takes up, from its shape.
struct PartExtent {
  std::vector<Eigen::Vector3d> vertices;   ///< of its pieces, in O
  std::vector<Eigen::Vector2d> footprint;  ///< convex hull of them in x, y
  double radius = 0;  ///< of the sphere about O that holds it

  explicit PartExtent(const Part& part);
  double Lowest(const Eigen::Isometry3d& X_WO) const;   ///< z in W
  double Highest(const Eigen::Isometry3d& X_WO) const;  ///< z in W
  /// About the part's origin, in the plane.
  double RadiusAcross(const Eigen::Isometry3d& X_WO) const;
};

/// Distance of two convex outlines; 0 if they overlap.
double DistanceBetween(const std::vector<Eigen::Vector2d>& a,
                       const std::vector<Eigen::Vector2d>& b);

/// [m] How far a part moves at least if it is put elsewhere.
inline constexpr double kMinMove = 0.08;

/// Finds places for upright parts in the parts area.
class PlacementSampler {
 public:
  struct Placed {
    std::string part;
    Eigen::Isometry3d X_WO;
  };
  PlacementSampler(const PartTable& table, const CellLayout& layout,
                   double gap);

  /// What does not stand anywhere at the start.
  struct Starts {
    std::vector<Placed> placed;   ///< is where it is
    std::set<std::string> lying;  ///< lies on its side, anywhere
    bool Has(const std::string& part) const;
  };

  /// Whether parts may lie so; an empty one accepts all.
  using Accept = std::function<bool(const std::vector<Placed>& scene)>;

  /// Random poses of all free parts.
  /// @throws std::runtime_error if they do not fit in 1000 attempts.
  std::vector<Placed> Scatter(std::mt19937_64& random,
                              const Accept& accept = {}) const {
    return Scatter({}, random, accept);
  }
  std::vector<Placed> Scatter(const Starts& starts, std::mt19937_64& random,
                              const Accept& accept = {}) const;

  /// A random place for `part` at least the gap away from all others and
  /// `min_way` away from where it is.
  std::optional<Eigen::Isometry3d> FreePlace(const std::string& part,
                                             const std::vector<Placed>& scene,
                                             double min_way,
                                             std::mt19937_64& random,
                                             const Accept& accept = {}) const;

  const PartExtent& ExtentOf(const std::string& part) const {
    return extents_.at(part);
  }

 private:
  std::vector<Eigen::Vector2d> OutlineAt(const Placed& placed) const;
  /// A random place, turned anyhow about the vertical.
  /// @param R_WO  how it is tipped before; nullptr: it stands
  std::optional<Placed> TryPlace(
      const std::string& part, const Eigen::Matrix3d* R_WO,
      const std::vector<std::vector<Eigen::Vector2d>>& taken,
      std::mt19937_64& random) const;

  std::vector<std::string> free_parts_;  // the largest first
  std::map<std::string, PartExtent> extents_;
  CellLayout::PartsArea area_;
  double gap_;
};

}  // namespace cell::vtb
