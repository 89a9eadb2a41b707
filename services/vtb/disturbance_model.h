#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/hand_actor.h"
#include "services/vtb/help_request.h"
#include "services/vtb/placement_sampler.h"
#include "services/vtb/script.h"
#include "services/vtb/within_reach.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// A person beside the cell while it does a task by itself: moves, takes,
/// places parts at times of chance, or does what the cell asks for. One hand,
/// which keeps away from what the arms are at. A value.
class DisturbanceModel {
 public:
  /// @pre the script has one. The parts lie in `world`.
  DisturbanceModel(std::shared_ptr<const Demonstrations> demonstrations,
                   const std::string& script, uint64_t seed,
                   const World& world);

  /// One tick: moves the hand of `world` for the coming `dt` [s].
  void Update(double dt, World& world);
  /// The cell asks for this placement. It is done once, unless it fails.
  void AskFor(const std::string& part, const std::string& site);
  /// The cell asks for one of these; none: it asks for nothing any more. The
  /// person does one that is possible, and if the question still stands after a
  /// while, another one.
  void AskFor(std::vector<HelpRequest> requests);

  bool is_idle() const { return hand_.is_idle(); }
  /// Nothing that was planned is still to come, or the next has been tried and
  /// cannot be done as things are.
  bool is_done() const {
    return is_idle() && num_tries_left_ == 0 &&
           (times_.empty() || has_tried_in_vain_);
  }

 private:
  struct Placement {
    std::string part, site;
  };

  void Begin(World& world);
  std::vector<PlacementSampler::Placed> SceneIn(const World& world) const;
  std::optional<Eigen::Isometry3d> AtOneOfThePlaces(const std::string& part,
                                                    const World& world);
  void Help(World& world);
  bool Disturb(const World& world);
  bool PlaceSomething(const World& world);
  bool Place(const Placement& placement, const World& world);
  std::vector<std::string> LooseParts(const World& world) const;
  std::optional<Eigen::Isometry3d> Somewhere(const std::string& part,
                                             const World& world);

  std::shared_ptr<const Demonstrations> demonstrations_;
  const Script* script_;
  std::shared_ptr<const PlacementSampler> sampler_;
  std::mt19937_64 random_;
  HandActor hand_;
  WithinReach reach_;
  std::vector<double> times_;  // [s] when it disturbs, ascending
  double time_ = 0;
  bool has_tried_in_vain_ = false;
  std::optional<Placement> requested_;
  std::vector<HelpRequest> requests_;
  int num_tries_left_ = 0;  // to answer them
  double begin_time_ = 0;   // [s] of the next try
};

}  // namespace cell::vtb
