#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"

namespace cell {

/// Finds the experiences [state before, action, state after] of one episode
/// (section V-C) in what was sensed and done. The state before a manipulation
/// is that of the last key frame before the part was picked up; the state after
/// it is that of the key frame at which it was placed. A manipulation during
/// which another one was going on is left out: it cannot be told which of them
/// changed what.
class ExperienceTracer {
 public:
  /// `world` must outlive it.
  explicit ExperienceTracer(const RuleWorld& world) : world_(world) {}

  /// In the order of sensing; a key frame may be sensed several times: the
  /// first time counts for a manipulation.
  void Sensed(int64_t key_frame, int64_t utime, const State& state);
  /// A manipulation that was recognised, whatever came of it.
  void Done(const GroundAction& action, int64_t pick_key_frame,
            int64_t place_key_frame);
  /// The reverse of the action: what was sensed last is the state before it.
  void Reversed(const GroundAction& action, int64_t pick_key_frame,
                int64_t place_key_frame);
  /// A manipulation that was not recognised as an action.
  void Moved(int64_t pick_key_frame, int64_t place_key_frame);
  /// An action that was begun and did not succeed [us].
  void Failed(const GroundAction& action, int64_t begin_utime,
              int64_t end_utime);

  /// An action that a person tried from `begin_utime` to `end_utime` [us], and
  /// says that it changed nothing: the state is the last one that was sensed
  /// before it, if there was sensing meanwhile.
  void Attempted(const GroundAction& action, int64_t begin_utime,
                 int64_t end_utime);

  /// In the order of the ends of the actions; failed ones last.
  std::vector<rules::Experience> Experiences() const;

 private:
  struct Sensing {
    int64_t key_frame;
    int64_t utime;
    State state;
  };
  struct Manipulation {
    std::optional<GroundAction> action;
    int64_t pick;
    int64_t place;
    bool is_reversed;
  };
  struct Failure {
    GroundAction action;
    int64_t begin_utime;
    int64_t end_utime;
    bool is_sensed_afterwards;
  };

  bool IsAlone(const Manipulation& manipulation) const;
  std::optional<rules::Experience> Of(const Manipulation& manipulation) const;
  std::optional<rules::Experience> Of(const Failure& failure) const;

  const RuleWorld& world_;
  std::vector<Sensing> sensings_;
  std::vector<Manipulation> manipulations_;
  std::vector<Failure> failures_;
};

}  // namespace cell
