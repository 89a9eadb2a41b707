#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "common/geometry/convex_solid.h"
#include "common/parts/part_table.h"

namespace cell {

/// Sample points of a surface in W, with the sphere that holds them.
class PointCloud {
 public:
  explicit PointCloud(std::vector<Eigen::Vector3d> points_W);

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  std::vector<Eigen::Vector3d> points_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

/// The shape of a part, prepared once for distance queries at any pose: the
/// pieces of parts.yaml that count for distances. Lengths in m.
class PartShape {
 public:
  /// @throws std::invalid_argument if no piece counts for distances.
  explicit PartShape(const Part& part);
  ~PartShape();
  PartShape(PartShape&&) noexcept;

  /// In O.
  const Eigen::AlignedBox3d& box() const { return box_; }
  const std::vector<ConvexSolid>& solids() const { return solids_; }

  /// Distance of two posed parts, 0 if they penetrate. What is beyond
  /// `cutoff` is reported as `cutoff`, and costs next to nothing. The search
  /// ends as soon as a distance of at most `enough` is found: below it the
  /// value is only an upper bound.
  static double Distance(const PartShape& a, const Eigen::Isometry3d& X_WA,
                         const PartShape& b, const Eigen::Isometry3d& X_WB,
                         double cutoff, double enough = 0);

  /// Distance of the part to the nearest of the points, as above.
  double DistanceTo(const PointCloud& cloud, const Eigen::Isometry3d& X_WO,
                    double cutoff, double enough = 0) const;

  /// z in W of the lowest and of the highest point; the table's top is z = 0.
  double LowestZ(const Eigen::Isometry3d& X_WO) const;
  double HighestZ(const Eigen::Isometry3d& X_WO) const;

  /// By how much the part at X_WB could grow on its tightest side and still be
  /// inside this part's bounding box: negative if it sticks out.
  double Slack(const Eigen::Isometry3d& X_WO, const PartShape& content,
               const Eigen::Isometry3d& X_WB) const;

 private:
  struct Collision;

  double Reach(const Eigen::Vector3d& n_O) const;

  std::vector<ConvexSolid> solids_;
  std::unique_ptr<Collision> collision_;
  Eigen::AlignedBox3d box_;
};

/// Shapes of all parts of the table, in its order.
std::vector<PartShape> ShapesOf(const PartTable& table);

}  // namespace cell
