#include "common/rules/simulation.h"

namespace cell::rules {

uint64_t RandomNumbers::Next() {
  state_ += 0x9e3779b97f4a7c15;
  uint64_t mixed = state_;
  mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9;
  mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111eb;
  return mixed ^ mixed >> 31;
}

double RandomNumbers::Uniform() {
  return static_cast<double>(Next() >> 11) * 0x1p-53;
}

int RandomNumbers::Below(int number) {
  return static_cast<int>(Uniform() * number);
}

WorldState Simulate(const NdrRules& truth, const World& world,
                    const GroundAct& act, const WorldState& before,
                    RandomNumbers* random) {
  double left = random->Uniform();
  const auto coverage = FindCoverage(truth, act, before, world);
  if (!coverage) return before;
  for (const Outcome& outcome : coverage->rule->outcomes) {
    left -= outcome.probability;
    if (left < 0) return Apply(outcome, coverage->binding, before, world);
  }
  return before;
}

ExperienceSet DrawExperiences(const NdrRules& truth,
                              std::shared_ptr<const World> world,
                              const WorldState& initial, int number,
                              int episode_length, uint64_t seed) {
  RandomNumbers random(seed);
  ExperienceSet set{std::move(world), {}};
  WorldState state = initial;
  for (int i = 0; i < number; ++i) {
    if (i % episode_length == 0) state = initial;
    std::vector<GroundAct> acts;
    for (GroundAct& act : GroundActs(*set.world, state)) {
      if (FindCoverage(truth, act, state, *set.world)) {
        acts.push_back(std::move(act));
      }
    }
    if (acts.empty()) {
      state = initial;
      continue;
    }
    const GroundAct& act =
        acts[static_cast<size_t>(random.Below(static_cast<int>(acts.size())))];
    WorldState after = Simulate(truth, *set.world, act, state, &random);
    set.experiences.push_back({state, act, after});
    state = std::move(after);
  }
  return set;
}

}  // namespace cell::rules
