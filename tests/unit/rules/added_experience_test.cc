#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "common/rules/learning/learner.h"
#include "common/rules/simulation.h"
#include "tests/unit/rules/manipulation_domain.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

/// S(R) of eq. (1) in its two parts, worked out apart from the learner.
struct ScoreParts {
  double log_likelihood = 0;
  double penalty = 0;
  double score() const { return log_likelihood - penalty; }
};

double ProbabilityOf(const Experience& e, const Coverage& coverage,
                     const World& world, const LearnerOptions& options) {
  double p = coverage.rule->noise * options.p_min;
  for (const Outcome& outcome : coverage.rule->outcomes) {
    if (Apply(outcome, coverage.binding, e.before, world) == e.after) {
      p += outcome.probability;
    }
  }
  return p;
}

ScoreParts ScoreOf(const NdrRules& rules, const ExperienceSet& set,
                   const LearnerOptions& options) {
  ScoreParts parts;
  std::map<int, std::pair<int, int>> uncovered;  // same, changed; by action
  for (const Experience& e : set.experiences) {
    const auto coverage = FindCoverage(rules, e.act, e.before, *set.world);
    if (coverage) {
      parts.log_likelihood +=
          std::log(ProbabilityOf(e, *coverage, *set.world, options));
    } else {
      ++(e.before == e.after ? uncovered[e.act.action].first
                             : uncovered[e.act.action].second);
    }
  }
  for (const auto& [action, counts] : uncovered) {
    const auto [same, changed] = counts;
    const double all = same + changed;
    if (same > 0) parts.log_likelihood += same * std::log(same / all);
    if (changed > 0) {
      parts.log_likelihood +=
          changed * std::log(changed / all * options.p_min_default);
    }
  }
  for (const Rule& rule : rules.rules) {
    parts.penalty += options.alpha * rule.num_literals();
  }
  return parts;
}

/// Rules that cover an experience twice are no solution.
bool CoverTwice(const NdrRules& rules, const Experience& e,
                const World& world) {
  int number = 0;
  for (const Rule& rule : rules.rules) {
    number += rule.action == e.act.action &&
              Bind(rule, e.act.arguments, e.before, world).has_value();
  }
  return number > 1;
}

TEST(AddedExperience, LowersTheLikelihoodOnlyForASmallerPenalty) {
  const NdrRules truth = ParseRules(kManipulationRules, "r");
  const auto world =
      std::make_shared<World>(truth.symbols, ObjectsFrom(kManipulationObjects));
  const WorldState initial = ParseState(kManipulationState, "d", 1, *world);
  const LearnerOptions options;
  int num_lower = 0;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const ExperienceSet all =
        DrawExperiences(truth, world, initial, 60, 20, seed);
    ExperienceSet seen{world, {}};
    Learner learner(world, options);
    NdrRules before{world->shared_symbols(), {}};
    for (const Experience& e : all.experiences) {
      seen.experiences.push_back(e);
      const bool is_allowed = !CoverTwice(before, e, *world);
      const ScoreParts kept = ScoreOf(before, seen, options);
      learner.Add(e);
      learner.Learn();
      before = learner.Rules();
      const ScoreParts learned = ScoreOf(before, seen, options);
      EXPECT_NEAR(learned.score(), learner.Score(), 1e-6);
      if (!is_allowed) continue;
      // What is lost in likelihood is won in penalty.
      EXPECT_GE(learned.log_likelihood - kept.log_likelihood,
                learned.penalty - kept.penalty - 1e-6)
          << "seed " << seed << ", " << seen.experiences.size() << "\n"
          << ToText(before);
      num_lower += learned.log_likelihood < kept.log_likelihood - 1e-6;
    }
  }
  EXPECT_GT(num_lower, 0);  // the penalty does have a say
}

}  // namespace
}  // namespace cell::rules
