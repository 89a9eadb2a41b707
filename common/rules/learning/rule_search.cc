#include "common/rules/learning/rule_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {
namespace {

/// A score must rise by more than rounding.
constexpr double kLeastGain = 1e-7;

void InsertSorted(int number, std::vector<int>* numbers) {
  const auto it = std::ranges::lower_bound(*numbers, number);
  if (it == numbers->end() || *it != number) numbers->insert(it, number);
}

}  // namespace

size_t RuleSearch::KeyHash::operator()(
    const std::pair<std::vector<int>, BitSet>& key) const {
  uint64_t hash = key.second.Hash();
  for (const int number : key.first) {
    hash = (hash ^ static_cast<uint64_t>(number)) * 0x9e3779b97f4a7c15;
  }
  return hash ^ hash >> 31;
}

RuleSearch::RuleSearch(std::shared_ptr<const World> world, int action,
                       const LearnerOptions& options)
    : options_(options), table_(std::move(world), action), lifter_(&table_) {}

void RuleSearch::Add(const Experience& experience) {
  table_.Add(experience);
  induced_.clear();
  literals_.clear();
  std::vector<SearchRule> old;
  std::swap(old, rules_);
  for (const SearchRule& rule : old) {
    if (auto again = Make(rule.references, rule.context)) {
      rules_.push_back(std::move(*again));
    }
  }
  std::ranges::stable_sort(rules_, std::greater(), &SearchRule::score);
  BitSet covered(table_.size());
  std::erase_if(rules_, [&](const SearchRule& rule) {
    if (rule.covers.Meets(covered)) return true;
    covered |= rule.covers;
    return false;
  });
}

std::optional<SearchRule> RuleSearch::Make(std::vector<int> references,
                                           std::vector<int> context) {
  SearchRule rule;
  rule.covers = BitSet(table_.size(), true);
  size_t num_literals = context.size();
  for (const int term : references) {
    rule.covers &= table_.Bound(term);
    num_literals += table_.definition(term).size();
  }
  for (const int number : context) rule.covers &= table_.Before(number);
  if (rule.covers.IsEmpty()) return std::nullopt;
  rule.induced = Induce(references, rule.covers);
  rule.references = std::move(references);
  rule.context = std::move(context);
  num_literals += static_cast<size_t>(rule.induced->num_literals);
  rule.score = rule.induced->log_likelihood -
               options_.alpha * static_cast<double>(num_literals);
  return rule;
}

std::shared_ptr<const Induced> RuleSearch::Induce(
    const std::vector<int>& references, const BitSet& covers) {
  auto& induced = induced_[{references, covers}];
  if (!induced) {
    induced = std::make_shared<const Induced>(
        InduceOutcomes(references, covers, options_, &table_, &lifter_));
  }
  return induced;
}

std::optional<SearchRule> RuleSearch::With(const SearchRule& rule,
                                           int literal) {
  std::vector<int> context = rule.context;
  InsertSorted(literal, &context);
  return Make(rule.references, std::move(context));
}

std::optional<SearchRule> RuleSearch::Without(const SearchRule& rule,
                                              size_t index) {
  std::vector<int> context = rule.context;
  context.erase(context.begin() + static_cast<std::ptrdiff_t>(index));
  return Make(rule.references, std::move(context));
}

std::optional<SearchRule> RuleSearch::WithReference(const SearchRule& rule,
                                                    int from,
                                                    std::optional<int> to) {
  std::map<int, std::optional<int>> replaced = {{from, to}};
  const auto replace = [&](Feature feature) -> std::optional<Feature> {
    for (const auto& [old, now] : replaced) {
      if (!feature.Names(old)) continue;
      if (!now) return std::nullopt;
      feature = feature.With(old, *now);
    }
    return feature;
  };
  std::vector<int> references;
  for (const int term : rule.references) {
    std::optional<int> now = term == from ? to : term;
    if (term != from) {
      std::vector<Feature> definition;
      for (const Feature& feature : table_.definition(term)) {
        const auto other = replace(feature);
        if (!other) now.reset();
        if (other) definition.push_back(*other);
      }
      std::ranges::sort(definition);
      if (now) now = table_.Reference(definition);
      if (now != term) replaced[term] = now;
    }
    if (now && std::ranges::count(references, *now) == 0) {
      references.push_back(*now);
    }
  }
  std::vector<int> context;
  for (const int number : rule.context) {
    const auto feature = replace(table_.feature(number));
    if (feature) InsertSorted(table_.Number(*feature), &context);
  }
  return Make(std::move(references), std::move(context));
}

double RuleSearch::DefaultScore(const BitSet& rest) const {
  const double n = rest.Count();
  const double same = rest.CountWith(table_.unchanged());
  double score = same > 0 ? same * std::log(same / n) : 0;
  if (n > same) {
    score += (n - same) * std::log((n - same) / n * options_.p_min_default);
  }
  return score;
}

double RuleSearch::score() const {
  return ScoreWith({});
}

std::vector<bool> RuleSearch::KeptWith(const Proposal& proposal) const {
  std::vector<bool> is_kept(rules_.size(), true);
  for (const size_t index : proposal.removed) is_kept[index] = false;
  for (size_t i = 0; i < rules_.size(); ++i) {
    for (const SearchRule& added : proposal.added) {
      if (rules_[i].covers.Meets(added.covers)) is_kept[i] = false;
    }
  }
  return is_kept;
}

double RuleSearch::ScoreWith(const Proposal& proposal) const {
  BitSet rest(table_.size(), true);
  double score = 0;
  for (const SearchRule& added : proposal.added) {
    BitSet twice = added.covers;
    twice -= rest;
    if (!twice.IsEmpty()) return -std::numeric_limits<double>::infinity();
    rest -= added.covers;
    score += added.score;
  }
  const std::vector<bool> is_kept = KeptWith(proposal);
  for (size_t i = 0; i < rules_.size(); ++i) {
    if (!is_kept[i]) continue;
    rest -= rules_[i].covers;
    score += rules_[i].score;
  }
  return score + DefaultScore(rest);
}

void RuleSearch::Apply(const Proposal& proposal) {
  const std::vector<bool> is_kept = KeptWith(proposal);
  std::vector<SearchRule> rules;
  for (size_t i = 0; i < rules_.size(); ++i) {
    if (is_kept[i]) rules.push_back(std::move(rules_[i]));
  }
  rules.insert(rules.end(), proposal.added.begin(), proposal.added.end());
  rules_ = std::move(rules);
  ++num_steps_;
}

bool RuleSearch::Step(size_t op) {
  std::optional<Proposal> best;
  double best_score = score() + kLeastGain;
  kSearchOperators[op].propose(*this, [&](const Proposal& proposal) {
    const double now = ScoreWith(proposal);
    if (now <= best_score) return;
    best_score = now;
    best = proposal;
  });
  if (best) Apply(*best);
  return best.has_value();
}

void RuleSearch::Run() {
  // The operators in turn, until all of them fail one after the other.
  size_t num_failed = 0;
  for (size_t op = 0; num_failed < kSearchOperators.size();
       op = (op + 1) % kSearchOperators.size()) {
    ++num_failed;
    while (Step(op)) num_failed = 0;
  }
}

BitSet RuleSearch::Unexplained() const {
  BitSet unexplained(table_.size(), true);
  unexplained -= table_.unchanged();
  for (const SearchRule& rule : rules_) {
    for (const InducedOutcome& outcome : rule.induced->outcomes) {
      unexplained -= outcome.covers;
    }
  }
  return unexplained;
}

std::vector<double> RuleSearch::LogLikelihoods() const {
  BitSet rest(table_.size(), true);
  std::vector<double> logs(static_cast<size_t>(table_.size()));
  for (const SearchRule& rule : rules_) {
    rest -= rule.covers;
    rule.covers.ForEach([&](int e) {
      logs[static_cast<size_t>(e)] =
          std::log(Likelihood(*rule.induced, e, options_.p_min));
    });
  }
  const double n = rest.Count();
  const double same = rest.CountWith(table_.unchanged());
  rest.ForEach([&](int e) {
    logs[static_cast<size_t>(e)] =
        table_.unchanged().Has(e)
            ? std::log(same / n)
            : std::log((n - same) / n * options_.p_min_default);
  });
  return logs;
}

const SearchRule* RuleSearch::CoveringRule(int e) const {
  for (const SearchRule& rule : rules_) {
    if (rule.covers.Has(e)) return &rule;
  }
  return nullptr;
}

}  // namespace cell::rules
