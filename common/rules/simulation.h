#pragma once

#include <cstdint>

#include "common/rules/experience.h"

namespace cell::rules {

/// Numbers that look random; the same for a seed on every machine (SplitMix64).
class RandomNumbers {
 public:
  explicit RandomNumbers(uint64_t seed) : state_(seed) {}
  uint64_t Next();
  /// From 0 to 1, without 1.
  double Uniform();
  /// From 0 to `number` - 1. The number must be positive.
  int Below(int number);

 private:
  uint64_t state_;
};

/// The state after an action by rules that are true. Where no rule or several
/// cover it, nothing changes; nor does anything in a noise outcome.
WorldState Simulate(const NdrRules& truth, const World& world,
                    const GroundAct& act, const WorldState& before,
                    RandomNumbers* random);

/// Experiences drawn from rules: from a state on, actions chosen at random
/// among those that a rule covers, each with its outcome by chance. Begins
/// again at `initial` when no rule covers any action, and after
/// `episode_length` actions.
ExperienceSet DrawExperiences(const NdrRules& truth,
                              std::shared_ptr<const World> world,
                              const WorldState& initial, int number,
                              int episode_length, uint64_t seed);

}  // namespace cell::rules
