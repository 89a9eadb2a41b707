#include "common/rexd/agent_rates.h"

#include <utility>

namespace cell::rexd {

using namespace rules;
namespace {

/// Experiences that each outcome explains; those that several do are shared.
std::vector<double> SharesOf(const Coverage& coverage,
                             const Experience& experience, const World& world) {
  std::vector<double> shares;
  double sum = 0;
  for (const Outcome& outcome : coverage.rule->outcomes) {
    const bool explains = Apply(outcome, coverage.binding, experience.before,
                                world) == experience.after;
    shares.push_back(explains ? outcome.probability : 0);
    sum += shares.back();
  }
  for (double& share : shares) share = sum > 0 ? share / sum : 0;
  return shares;
}

}  // namespace

AgentRules WithRatesOf(const std::vector<Experience>& experiences,
                       NdrRules rules, const World& world) {
  std::vector<int> counts(rules.rules.size(), 0);
  std::vector<std::vector<double>> sums(rules.rules.size());
  for (const Experience& experience : experiences) {
    const auto coverage =
        FindCoverage(rules, experience.act, experience.before, world);
    if (!coverage) continue;
    const auto r = static_cast<size_t>(coverage->rule - rules.rules.data());
    const auto shares = SharesOf(*coverage, experience, world);
    sums[r].resize(shares.size(), 0);
    for (size_t i = 0; i < shares.size(); ++i) sums[r][i] += shares[i];
    ++counts[r];
  }
  for (size_t r = 0; r < rules.rules.size(); ++r) {
    Rule& rule = rules.rules[r];
    if (counts[r] == 0) continue;
    double num_explained = 0;
    for (size_t i = 0; i < rule.outcomes.size(); ++i) {
      rule.outcomes[i].probability = sums[r][i] / counts[r];
      num_explained += sums[r][i];
    }
    rule.noise = (counts[r] - num_explained) / counts[r];
  }
  return {std::move(rules), std::move(counts)};
}

}  // namespace cell::rexd
