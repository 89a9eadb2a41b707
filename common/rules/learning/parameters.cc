#include <cmath>
#include <utility>

#include "common/rules/learning/induced.h"

namespace cell::rules {
namespace {

/// Experiences that the same outcomes explain.
struct Pattern {
  std::vector<int> outcomes;
  double count = 0;
};

bool AreDisjoint(const std::vector<InducedOutcome>& outcomes, int size) {
  BitSet all(size);
  for (const InducedOutcome& outcome : outcomes) {
    if (outcome.covers.Meets(all)) return false;
    all |= outcome.covers;
  }
  return true;
}

void Count(const BitSet& covered, double p_min, Induced* induced) {
  const double n = covered.Count();
  double rest = n;
  for (InducedOutcome& outcome : induced->outcomes) {
    const int count = outcome.covers.Count();
    outcome.probability = count / n;
    rest -= count;
  }
  induced->noise = rest / n;
  const double unexplained = induced->noise * p_min;
  double sum = rest > 0 ? rest * std::log(unexplained) : 0;
  for (const InducedOutcome& outcome : induced->outcomes) {
    if (outcome.probability <= 0) continue;
    sum +=
        outcome.probability * n * std::log(outcome.probability + unexplained);
  }
  induced->log_likelihood = sum;
}

std::vector<Pattern> PatternsOf(const BitSet& covered,
                                const std::vector<InducedOutcome>& outcomes) {
  std::map<std::vector<int>, double> counts;
  std::vector<int> pattern;
  covered.ForEach([&](int e) {
    pattern.clear();
    for (size_t i = 0; i < outcomes.size(); ++i) {
      if (outcomes[i].covers.Has(e)) pattern.push_back(static_cast<int>(i));
    }
    counts[pattern] += 1;
  });
  std::vector<Pattern> patterns;
  for (const auto& [indices, count] : counts) {
    patterns.push_back({indices, count});
  }
  return patterns;
}

double LogLikelihoodOf(const std::vector<Pattern>& patterns, double p_min,
                       const Induced& induced) {
  double sum = 0;
  for (const Pattern& pattern : patterns) {
    double p = induced.noise * p_min;
    for (const int i : pattern.outcomes) {
      p += induced.outcomes[static_cast<size_t>(i)].probability;
    }
    sum += pattern.count * std::log(p);
  }
  return sum;
}

/// One step of expectation maximisation.
void Reestimate(const std::vector<Pattern>& patterns, double n, double p_min,
                Induced* induced) {
  std::vector<double> shares(induced->outcomes.size(), 0);
  double noise = 0;
  for (const Pattern& pattern : patterns) {
    double p = induced->noise * p_min;
    for (const int i : pattern.outcomes) {
      p += induced->outcomes[static_cast<size_t>(i)].probability;
    }
    noise += pattern.count * induced->noise * p_min / p;
    for (const int i : pattern.outcomes) {
      const auto k = static_cast<size_t>(i);
      shares[k] += pattern.count * induced->outcomes[k].probability / p;
    }
  }
  induced->noise = noise / n;
  for (size_t i = 0; i < shares.size(); ++i) {
    induced->outcomes[i].probability = shares[i] / n;
  }
}

void Maximise(const BitSet& covered, double p_min, Induced* induced) {
  constexpr int kMaxSteps = 500;
  constexpr double kPrecision = 1e-9;
  const std::vector<Pattern> patterns = PatternsOf(covered, induced->outcomes);
  const double share =
      1.0 / (static_cast<double>(induced->outcomes.size()) + 1);
  for (InducedOutcome& outcome : induced->outcomes) outcome.probability = share;
  induced->noise = share;
  double last = LogLikelihoodOf(patterns, p_min, *induced);
  for (int step = 0; step < kMaxSteps; ++step) {
    Reestimate(patterns, covered.Count(), p_min, induced);
    const double now = LogLikelihoodOf(patterns, p_min, *induced);
    const bool is_done = now - last < kPrecision;
    last = now;
    if (is_done) break;
  }
  induced->log_likelihood = last;
}

}  // namespace

void LearnParameters(const BitSet& covered, double p_min, Induced* induced) {
  induced->log_likelihood = 0;
  induced->noise = 0;
  if (covered.IsEmpty()) return;
  if (AreDisjoint(induced->outcomes, covered.size())) {
    Count(covered, p_min, induced);
  } else {
    Maximise(covered, p_min, induced);
  }
}

double Likelihood(const Induced& induced, int e, double p_min) {
  double p = induced.noise * p_min;
  for (const InducedOutcome& outcome : induced.outcomes) {
    if (outcome.covers.Has(e)) p += outcome.probability;
  }
  return p;
}

}  // namespace cell::rules
