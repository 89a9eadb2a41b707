#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/part_shape.h"
#include "common/layout/hand_type.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// The fingers of an arm's gripper: kinematic, at one speed, until all of them
/// touch a part; then they hold it (World's grip) until they open again.
class Gripper {
 public:
  struct Params {
    double speed = 0.10;     ///< [m/s] of the opening
    double touch = 0.0012;   ///< [m] nearer than this a finger touches
    double release = 0.004;  ///< [m] that they open before they let go
  };
  enum class State : int8_t { kOpen = 0, kClosed = 1, kGripping = 2 };

  /// `shapes` of all parts of the world's table; all must outlive this object.
  Gripper(const std::string& name, const HandType& type,
          const std::vector<PartShape>& shapes, const Params& params);

  void Reset(double opening);
  /// Fingers shall be so far apart [m], placed as `grip` says ("" or unknown:
  /// as they are). They are rearranged only while they hold nothing.
  void Command(double opening, const std::string& grip);
  /// One tick of `dt` [s]; moves the hand of `world` to X_WG.
  void Update(double dt, const Eigen::Isometry3d& X_WG, World& world);

  double opening() const { return opening_; }
  /// How the fingers stand: a grip of the hand's type.
  const std::string& stance() const { return stance_; }
  State state(const World& world) const;

 private:
  bool IsFree(const World& world, size_t part) const;
  std::optional<std::string> PartBetween(const Eigen::Isometry3d& X_WG,
                                         const World& world) const;

  std::string name_;
  const HandType& type_;
  const std::vector<PartShape>& shapes_;
  Params params_;
  std::vector<std::vector<Eigen::Vector3d>> surfaces_;  // of each box, in B
  double opening_ = 0;
  double goal_ = 0;
  double grip_opening_ = 0;    // when it gripped
  std::string grip_, stance_;  // that they shall have, and have
};

}  // namespace cell::vtb
