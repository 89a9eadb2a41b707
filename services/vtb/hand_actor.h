#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/hand_stage.h"

namespace cell::vtb {

/// One hand of a person at work: runs the stages of its actions one after the
/// other, with feedback. A value: a copy goes on in the same way.
class HandActor {
 public:
  HandActor(std::string hand, const HumanMotionParams& human_motion,
            const World& world);

  /// Appends the stages of the action.
  void Do(const HandAction& action);
  /// Reaches for the part and holds it, clear of the site where it is.
  void PickUp(const std::string& part, const std::string& from_site);
  /// Brings a held part there and lets go.
  void Place(const std::string& part, const Target& target);
  void GoToRest();
  void Pause(double duration);

  /// One tick: moves the hand of `world` for the coming `dt` [s].
  void Update(double dt, World& world, const PlacementSampler& sampler,
              std::mt19937_64& random);

  bool is_idle() const { return stages_.empty(); }
  const std::string& hand() const { return hand_.name; }
  /// Parts that did not seat or move in spite of all tries.
  const std::vector<std::string>& failures() const { return hand_.failures; }
  /// The rest of its way in the plane, from its present position.
  std::vector<Eigen::Vector2d> WayAhead(const World& world) const;

 private:
  void Finish(const HandStage::Progress& progress);

  HandState hand_;
  std::deque<std::shared_ptr<const HandStage>> stages_;
  std::optional<StageRun> run_;  // of the first stage, once it has begun
};

}  // namespace cell::vtb
