#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/parts/part_table.h"
#include "services/robot_arm/motion_client.h"
#include "services/robot_arm/scene_monitor.h"

namespace cell::robot_arm {

/// True if a part has moved between two snapshots by more than they differ.
bool HasMoved(const Eigen::Isometry3d& X_WO_before,
              const Eigen::Isometry3d& X_WO_now);

/// Parts that an arm could take where they lie if all movable parts near them
/// were gone. Asks again about parts that have come to rest elsewhere.
class ReachableParts {
 public:
  /// All must outlive this object.
  ReachableParts(const PartTable& parts, const SceneMonitor& monitor,
                 MotionClient& client)
      : parts_(parts), monitor_(monitor), client_(client) {}
  ReachableParts(const ReachableParts&) = delete;
  ReachableParts& operator=(const ReachableParts&) = delete;

  /// New poses of the parts.
  void Update(const std::map<std::string, Eigen::Isometry3d>& poses);
  /// One tick of `dt` [s].
  void Step(double dt);
  /// Sorted; not what is in a person's hand.
  std::vector<std::string> List() const;

 private:
  void AskNext();

  const PartTable& parts_;
  const SceneMonitor& monitor_;
  MotionClient& client_;
  std::map<std::string, Eigen::Isometry3d> seen_;   // when last looked at
  std::map<std::string, Eigen::Isometry3d> asked_;  // where it was asked about
  std::vector<std::string> resting_;                // of the parts seen
  std::set<std::string> reachable_;
  std::vector<std::string> wanted_;  // that the inquiry is about
  std::unique_ptr<MotionInquiry> inquiry_;
};

}  // namespace cell::robot_arm
