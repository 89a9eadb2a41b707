#pragma once

#include <memory>
#include <random>

#include "common/experiences/rule_world.h"
#include "tests/unit/cranfield_domain.h"

namespace cell {

/// The shipped task as a world to learn in.
struct CranfieldRules : Cranfield {
  CranfieldRules()
      : world(std::make_shared<const Vocabulary>(domain->vocabulary()),
              domain->actions()) {}

  GroundAction Ground(const std::string& name,
                      const std::vector<std::string>& objects) const {
    return domain->FindGroundAction(name, objects).value();
  }

  bool IsReported(int atom) const {
    const Vocabulary& v = domain->vocabulary();
    return v.predicates()[static_cast<size_t>(v.Atom(atom).predicate)]
        .report.has_value();
  }

  /// Each atom that is sensed is true with the probability.
  State RandomState(double probability, std::mt19937_64& random) const {
    State state(domain->vocabulary().num_atoms());
    std::bernoulli_distribution is_true(probability);
    for (int atom = 0; atom < state.num_atoms(); ++atom) {
      if (!IsReported(atom) && is_true(random)) state.Set(atom, Truth::kTrue);
    }
    return state;
  }

  RuleWorld world;
};

}  // namespace cell
