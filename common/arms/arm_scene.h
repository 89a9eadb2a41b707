#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/arms/arm_bodies.h"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// "table", "pedestal", a part, a body ("gripper_right.finger_1") or the owner
/// of bodies ("gripper_right", "arm_left"), two of them.
using BodyPair = std::pair<std::string, std::string>;

/// How near bodies may come.
struct ClearanceRule {
  double clearance = 0.010;       ///< [m] wanted between the arm and all else
  std::vector<BodyPair> allowed;  ///< to come as near as they like
};

/// What an arm moves among: the table's top, the pedestal, the parts where
/// they are, the other arms and what they hold. Cheap to copy: copies share the
/// shapes. Asking changes nothing.
class ArmScene {
 public:
  /// Fixed parts stand on the pedestal; no other part is there yet; the arms
  /// are at home with empty hands. @throws std::invalid_argument for a part
  /// without shape.
  ArmScene(const PartTable& parts, const CellLayout& layout);

  /// All of these throw std::invalid_argument for names of unknown parts or
  /// arms.
  void PutPart(const std::string& part, const Eigen::Isometry3d& X_WO);
  void RemovePart(const std::string& part);
  /// Puts all parts that the map names; the others are gone.
  void PutParts(const std::map<std::string, Eigen::Isometry3d>& X_WO);
  void SetPosture(const std::string& arm, const ArmPosture& posture);
  /// The part goes with the arm's gripper from now on.
  void Hold(const std::string& arm, const std::string& part,
            const Eigen::Isometry3d& X_GO);
  /// Removes the part that the arm holds until it is put somewhere.
  void LetGo(const std::string& arm);

  /// Nothing if the arm may be in this posture, with what it holds; else why
  /// not, e.g. "gripper_right.finger_1 would hit NAME". Its own posture in the
  /// scene is ignored. Of its own bodies it checks those that could hit each
  /// other (MayCollide), at no more than `kSelfClearance`.
  std::optional<std::string> WhyBlocked(const std::string& arm,
                                        const ArmPosture& posture,
                                        const ClearanceRule& rule = {}) const;
  /// The same: a body of the arm and what it would hit.
  std::optional<BodyPair> FindTooNear(const std::string& arm,
                                      const ArmPosture& posture,
                                      const ClearanceRule& rule = {}) const;
  /// [m] From the arm in this posture and what it holds to the other arms and
  /// what they hold; up to `cutoff`.
  double DistanceToOthers(const std::string& arm, const ArmPosture& posture,
                          double cutoff) const;
  /// [m] From the arm in this posture and what it holds to the points in W and
  /// the parts, up to `cutoff`.
  double DistanceTo(const PointCloud& points,
                    const std::vector<std::string>& parts,
                    const std::string& arm, const ArmPosture& posture,
                    double cutoff) const;
  /// What is within `distance` [m] of the part at X_WO: parts, "table",
  /// "pedestal".
  std::vector<std::string> Neighbours(const std::string& part,
                                      const Eigen::Isometry3d& X_WO,
                                      double distance) const;
  /// The part that the arm's fingers grip in this posture: of those neither
  /// fixed nor held, the one that the farthest finger is nearest to.
  std::optional<std::string> FindGrasped(const std::string& arm,
                                         const ArmPosture& posture) const;

  const ArmPosture& PostureOf(const std::string& arm) const;
  /// Nothing if it is not there, or held.
  std::optional<Eigen::Isometry3d> PoseOf(const std::string& part) const;
  struct Held {
    std::string part;
    Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();
  };
  /// Nothing if its hand is empty.
  std::optional<Held> HeldBy(const std::string& arm) const;
  const CellLayout& layout() const;
  const PartTable& parts() const;

  static constexpr double kSelfClearance = 0.002;  ///< [m]

 private:
  struct Solid;   ///< a shape with its name
  struct Shapes;  ///< of all bodies; copies share them
  struct Posed;   ///< a solid where it is
  class Query;

  std::vector<Posed> BodiesOf(size_t arm,
                              const std::vector<Eigen::Isometry3d>& X_WB,
                              const Joints& q) const;
  /// The moving bodies of an arm in this posture, and what it holds.
  std::vector<Posed> Moving(size_t arm, const ArmPosture& posture) const;
  std::vector<Posed> OtherArms(size_t arm) const;
  static double Nearest(const std::vector<Posed>& moving,
                        const std::vector<Posed>& others, double cutoff);
  std::vector<Posed> Obstacles(size_t arm) const;
  size_t ArmIndex(const std::string& arm) const;
  size_t PartIndex(const std::string& part) const;

  std::shared_ptr<const Shapes> shapes_;
  std::vector<std::optional<Eigen::Isometry3d>> X_WO_;  ///< by part
  std::vector<ArmPosture> postures_;                    ///< by arm
  std::vector<std::vector<Eigen::Isometry3d>> X_WB_;    ///< of arms' bodies
  std::vector<std::optional<Held>> held_;               ///< by arm
};

}  // namespace cell
