#pragma once

#include <memory>
#include <vector>

#include "common/rules/rule.h"

namespace cell::rules {

/// E = [s, a, s'] (section V-C).
struct Experience {
  WorldState before;
  GroundAct act;
  WorldState after;
  bool operator==(const Experience&) const = default;
};

/// Experiences of one world.
struct ExperienceSet {
  std::shared_ptr<const World> world;
  std::vector<Experience> experiences;
};

}  // namespace cell::rules
