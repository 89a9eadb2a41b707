#include "common/rules/learning/induced.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace cell::rules {
namespace {

/// Of more distinct changes than these the rarest are noise.
constexpr size_t kMaxOutcomes = 32;

bool IsContradictory(const std::vector<Feature>& changes) {
  for (size_t i = 0; i + 1 < changes.size(); ++i) {
    for (size_t j = i + 1; j < changes.size(); ++j) {
      if (changes[i].symbol == changes[j].symbol &&
          changes[i].terms == changes[j].terms) {
        return true;
      }
    }
  }
  return false;
}

std::vector<Feature> Union(const std::vector<Feature>& a,
                           const std::vector<Feature>& b) {
  std::vector<Feature> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

/// Greedy search for the outcomes of one rule.
class OutcomeSearch {
 public:
  OutcomeSearch(const BitSet& covered, const LearnerOptions& options,
                FeatureTable* table)
      : covered_(covered), options_(options), table_(table) {}

  Induced Run(std::vector<std::vector<Feature>> distinct) {
    Induced best;
    for (auto& changes : distinct) {
      BitSet covers = CoveredBy(changes);
      best.outcomes.push_back({std::move(changes), std::move(covers), 0});
    }
    Learn(&best);
    while (auto better = Improve(best)) best = std::move(*better);
    return best;
  }

 private:
  void Learn(Induced* induced) const {
    LearnParameters(covered_, options_.p_min, induced);
    std::erase_if(induced->outcomes, [](const InducedOutcome& o) {
      return o.probability < 1e-12;
    });
    induced->num_literals = 0;
    for (const InducedOutcome& outcome : induced->outcomes) {
      induced->num_literals += static_cast<int>(outcome.changes.size());
    }
  }

  double ScoreOf(const Induced& induced) const {
    return induced.log_likelihood - options_.alpha * induced.num_literals;
  }

  /// The experiences after which all changes hold, if nothing else changes.
  BitSet CoveredBy(const std::vector<Feature>& changes) {
    BitSet all = covered_;
    std::vector<int> numbers;
    for (const Feature& change : changes) {
      numbers.push_back(table_->Number(change));
      all &= table_->After(numbers.back());
    }
    BitSet exact(covered_.size());
    all.ForEach([&](int e) {
      if (NumChanged(numbers, e) == table_->changes(e).size()) exact.Add(e);
    });
    return exact;
  }

  /// Ground atoms among the literals that did not hold before.
  size_t NumChanged(const std::vector<int>& numbers, int e) {
    std::vector<std::vector<int>> places;
    for (const int number : numbers) {
      if (table_->Before(number).Has(e)) continue;
      const Feature& feature = table_->feature(number);
      std::vector<int> place = {feature.symbol};
      for (const int32_t term : feature.terms) {
        place.push_back(table_->ObjectOf(term, e));
      }
      if (std::ranges::count(places, place) == 0) places.push_back(place);
    }
    return places.size();
  }

  std::optional<Induced> Improve(const Induced& now) {
    std::optional<Induced> best;
    double best_score = ScoreOf(now) + 1e-9;
    const auto consider = [&](Induced candidate) {
      Learn(&candidate);
      if (ScoreOf(candidate) <= best_score) return;
      best_score = ScoreOf(candidate);
      best = std::move(candidate);
    };
    for (size_t i = 0; i < now.outcomes.size(); ++i) {
      if (MayRemove(now, i)) consider(Without(now, i));
      for (size_t j = i + 1; j < now.outcomes.size(); ++j) {
        if (auto both = Conjoined(now, i, j)) consider(std::move(*both));
      }
    }
    return best;
  }

  /// False if to leave the experiences to noise costs more than the literals.
  bool MayRemove(const Induced& now, size_t i) const {
    BitSet alone = now.outcomes[i].covers;
    for (size_t j = 0; j < now.outcomes.size(); ++j) {
      if (j != i) alone -= now.outcomes[j].covers;
    }
    const double least_loss = -std::log(options_.p_min) * alone.Count();
    const auto num_literals =
        static_cast<double>(now.outcomes[i].changes.size());
    return least_loss < options_.alpha * num_literals + 20;
  }

  static Induced Without(const Induced& now, size_t i) {
    Induced other = now;
    other.outcomes.erase(other.outcomes.begin() +
                         static_cast<std::ptrdiff_t>(i));
    return other;
  }

  std::optional<Induced> Conjoined(const Induced& now, size_t i, size_t j) {
    const InducedOutcome& a = now.outcomes[i];
    const InducedOutcome& b = now.outcomes[j];
    std::vector<Feature> changes = Union(a.changes, b.changes);
    if (changes == a.changes || changes == b.changes) return std::nullopt;
    if (IsContradictory(changes)) return std::nullopt;
    BitSet covers = CoveredBy(changes);
    if (!covers.Meets(a.covers) || !covers.Meets(b.covers)) {
      return std::nullopt;
    }
    Induced other = Without(Without(now, j), i);
    other.outcomes.push_back({std::move(changes), std::move(covers), 0});
    return other;
  }

  const BitSet& covered_;
  const LearnerOptions& options_;
  FeatureTable* table_;
};

}  // namespace

int ChangeLifter::LiftOne(const std::vector<int>& references, int e) {
  std::vector<Feature> lifted;
  const int num_constants = table_->world().num_constants();
  const auto term_of = [&](int object) -> std::optional<int32_t> {
    for (int i = 0; i < table_->num_arguments(); ++i) {
      if (table_->ObjectOf(i, e) == object) return i;
    }
    for (const int reference : references) {
      if (table_->Object(reference, e) == object) return reference;
    }
    if (object < num_constants) return Feature::ObjectCode(object);
    return std::nullopt;
  };
  for (const Change& change : table_->changes(e)) {
    Feature feature;
    feature.symbol = change.symbol;
    feature.value = change.value;
    const bool is_integer = table_->world().symbols()[change.symbol].is_integer;
    feature.comparison = is_integer       ? Comparison::kEqual
                         : change.is_true ? Comparison::kTrue
                                          : Comparison::kFalse;
    for (size_t i = 0; i < change.objects.size(); ++i) {
      if (change.objects[i] < 0) break;
      const auto term = term_of(change.objects[i]);
      if (!term) return -1;
      feature.terms[i] = *term;
    }
    lifted.push_back(feature);
  }
  std::ranges::sort(lifted);
  const auto [it, is_new] =
      number_of_.emplace(lifted, static_cast<int>(pool_.size()));
  if (is_new) pool_.push_back(std::move(lifted));
  return it->second;
}

const std::vector<int>& ChangeLifter::Lift(const std::vector<int>& references) {
  std::vector<int>& numbers = lifted_[references];
  while (static_cast<int>(numbers.size()) < table_->size()) {
    numbers.push_back(LiftOne(references, static_cast<int>(numbers.size())));
  }
  return numbers;
}

Induced InduceOutcomes(const std::vector<int>& references,
                       const BitSet& covered, const LearnerOptions& options,
                       FeatureTable* table, ChangeLifter* lifter) {
  const std::vector<int>& numbers = lifter->Lift(references);
  std::vector<std::pair<int, int>> counts;  // -count, number
  covered.ForEach([&](int e) {
    const int number = numbers[static_cast<size_t>(e)];
    if (number < 0) return;
    const auto it =
        std::ranges::find(counts, number, &std::pair<int, int>::second);
    if (it == counts.end()) {
      counts.emplace_back(-1, number);
    } else {
      --it->first;
    }
  });
  std::ranges::sort(counts);
  if (counts.size() > kMaxOutcomes) counts.resize(kMaxOutcomes);
  std::vector<std::vector<Feature>> distinct;
  for (const auto& [count, number] : counts) {
    distinct.push_back(lifter->changes(number));
  }
  return OutcomeSearch(covered, options, table).Run(std::move(distinct));
}

}  // namespace cell::rules
