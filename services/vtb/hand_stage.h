#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/hand_path.h"
#include "services/vtb/placement_sampler.h"
#include "services/vtb/script.h"
#include "services/vtb/target.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// A person's hand: what one stage leaves to the next.
struct HandState {
  std::string name;
  HumanMotionParams human_motion;
  Eigen::Isometry3d X_WG = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WG_rest = Eigen::Isometry3d::Identity();
  double opening = 0;      ///< [m] between the fingers
  double grasp_width = 0;  ///< [m] of what was reached for last
  Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();  ///< of the held part
  double roll = 0;                    ///< [rad] of it between the fingertips
  Aim aim;                            ///< for the held part's target
  int num_tries = 0;                  ///< to insert it
  std::vector<std::string> failures;  ///< parts that did not seat, or move

  /// A factor by which a speed differs from the configured one.
  double Spread(std::mt19937_64& random) const;
};

/// What the stage that runs has begun; ends with it.
struct StageRun {
  double time = 0;                          ///< [s] in the stage
  HandPath path;                            ///< of X_WG
  double opening_from = 0, opening_to = 0;  ///< [m]
};

/// What a stage works on in a tick of `dt` [s].
struct HandContext {
  HandState& hand;
  StageRun& run;
  World& world;
  const PlacementSampler& sampler;
  std::mt19937_64& random;
  double dt = 0;
};

class HandStage;
/// Stages that are done one after the other, e.g. an insertion.
using HandAction = std::vector<std::shared_ptr<const HandStage>>;

/// One stage of a hand action. It never changes: all that does is in the hand's
/// state and the stage's run, so that a copy of these goes on in the same way.
class HandStage {
 public:
  struct Progress {
    bool is_done = false;
    HandAction next = {};         ///< to be done before what else is to come
    bool is_all_dropped = false;  ///< nothing else is to come
  };

  HandStage() = default;
  HandStage(const HandStage&) = delete;
  HandStage& operator=(const HandStage&) = delete;
  virtual ~HandStage() = default;

  /// Before the first tick. The run stands still where the hand is.
  virtual void Begin(HandContext& context) const;
  /// One tick; unless overridden, along the run's path to its end.
  virtual Progress Act(HandContext& context) const;
  /// Where in the plane it leads the hand; nothing if it stays near.
  virtual std::optional<Eigen::Vector2d> LeadsTo(const HandState& hand,
                                                 const World& world) const;
};

/// Moves hand and fingers along the run, the fingers within `duration` [s];
/// true at its end.
bool Follow(HandContext& context, double duration);

/// Lets the run lead straight there.
void GoStraight(const Eigen::Isometry3d& X_WG, double duration,
                HandContext& context);

/// Lets the run lead there over everything that stands between.
void GoOver(const Eigen::Isometry3d& X_WG, HandContext& context);

Eigen::Isometry3d Shifted(Eigen::Isometry3d X, const Eigen::Vector3d& by_W);
double AngleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

}  // namespace cell::vtb
