#include <algorithm>
#include <limits>
#include <set>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {
namespace {

using References = std::vector<int>;

/// Most examples that a definition of a reference is tried on.
constexpr size_t kMaxTrials = 16;
/// Definitions that are worked out into rules.
constexpr size_t kMaxDefinitions = 3;
/// Of more changed objects that no variable stands for, none is explained.
constexpr size_t kMaxReferences = 4;

/// A well mixed number (SplitMix64), to order examples.
uint64_t MixedNumber(uint64_t seed) {
  seed += 0x9e3779b97f4a7c15;
  seed = (seed ^ seed >> 30) * 0xbf58476d1ce4e5b9;
  seed = (seed ^ seed >> 27) * 0x94d049bb133111eb;
  return seed ^ seed >> 31;
}

/// Rules for one example at a time.
///
/// Pasula et al. begin with all literals that are true in the example and trim
/// them as long as the score rises. Here literals of the example are added to
/// none, as long as the score rises: the rules that trimming may lead to, at a
/// cost linear in the number of literals.
class Explanation {
 public:
  Explanation(RuleSearch& search, std::vector<int> examples)
      : search_(search),
        table_(search.table()),
        examples_(std::move(examples)),
        logs_(search.LogLikelihoods()) {}

  void Explain(int e, const Propose& propose) {
    const SearchRule* covering = search_.CoveringRule(e);
    const References base = covering ? covering->references : References();
    for (const References& references : ReferencesFor(e, base)) {
      auto rule = search_.Make(references, {});
      if (!rule) continue;
      Specialize(e, &*rule);
      ProposeWith(*rule, propose);
    }
  }

 private:
  /// The objects that the example changes and no variable stands for.
  std::vector<int> UnboundObjects(int e, const References& references) {
    std::vector<int> objects;
    for (const Change& change : table_.changes(e)) {
      for (const int object : change.objects) {
        if (object < table_.world().num_constants()) continue;
        bool is_bound = std::ranges::count(objects, object) > 0;
        for (int i = 0; i < table_.num_arguments(); ++i) {
          is_bound |= table_.ObjectOf(i, e) == object;
        }
        for (const int term : references) {
          is_bound |= table_.Object(term, e) == object;
        }
        if (!is_bound) objects.push_back(object);
      }
    }
    return objects;
  }

  /// Lists of references that stand for all objects that the example changes.
  std::vector<References> ReferencesFor(int e, const References& base) {
    std::vector<References> lists;
    const size_t num_unbound = UnboundObjects(e, base).size();
    if (num_unbound > kMaxReferences) return lists;
    if (num_unbound == 0) return {base};
    const int first = UnboundObjects(e, base)[0];
    for (const int term : BestDefinitions(e, first, base)) {
      References references = base;
      references.push_back(term);
      if (Complete(e, &references)) lists.push_back(references);
    }
    return lists;
  }

  bool Complete(int e, References* references) {
    for (;;) {
      const std::vector<int> unbound = UnboundObjects(e, *references);
      if (unbound.empty()) return true;
      const auto terms = BestDefinitions(e, unbound[0], *references);
      if (terms.empty()) return false;
      references->push_back(terms[0]);
    }
  }

  /// References that stand for the object in the example and, the more often
  /// the better, for a changed object in other ones.
  std::vector<int> BestDefinitions(int e, int object,
                                   const References& references) {
    std::vector<Feature> holding;
    for (const Feature& feature : search_.Definitions(references)) {
      if (table_.HoldsBefore(feature, e, object)) holding.push_back(feature);
    }
    std::vector<std::pair<int, std::vector<Feature>>> rated;
    const auto rate = [&](std::vector<Feature> definition) {
      if (table_.UniqueObject(definition, e) != object) return false;
      std::ranges::sort(definition);
      const int value = -3 * NumChangedObjects(definition, references) +
                        static_cast<int>(definition.size());
      rated.emplace_back(value, std::move(definition));
      return true;
    };
    std::vector<Feature> open;
    for (const Feature& feature : holding) {
      if (!rate({feature})) open.push_back(feature);
    }
    for (size_t i = 0; i + 1 < open.size(); ++i) {
      for (size_t j = i + 1; j < open.size(); ++j) rate({open[i], open[j]});
    }
    std::ranges::stable_sort(rated, std::less(),
                             [](const auto& entry) { return entry.first; });
    if (rated.size() > kMaxDefinitions) rated.resize(kMaxDefinitions);
    std::vector<int> terms;
    for (const auto& [value, definition] : rated) {
      terms.push_back(table_.Reference(definition));
    }
    return terms;
  }

  int NumChangedObjects(const std::vector<Feature>& definition,
                        const References& references) {
    int number = 0;
    for (size_t i = 0; i < std::min(examples_.size(), kMaxTrials); ++i) {
      const int object = table_.UniqueObject(definition, examples_[i]);
      if (object < 0) continue;
      const auto unbound = UnboundObjects(examples_[i], references);
      number += std::ranges::count(unbound, object) > 0;
    }
    return number;
  }

  /// What the rule says of its experiences beyond what is said of them now.
  double GainOf(const SearchRule& rule) const {
    double gain = rule.score;
    rule.covers.ForEach([&](int e) { gain -= logs_[static_cast<size_t>(e)]; });
    return gain;
  }

  /// Adds literals that are true in the example as long as that gains.
  void Specialize(int e, SearchRule* rule) {
    for (;;) {
      std::optional<SearchRule> best;
      double best_gain = GainOf(*rule) + 1e-7;
      std::set<uint64_t> tried = {rule->covers.Hash()};
      for (const int number : search_.Literals(rule->references)) {
        BitSet covers = rule->covers;
        covers &= table_.Before(number);
        if (!covers.Has(e) || !tried.insert(covers.Hash()).second) continue;
        auto other = search_.With(*rule, number);
        const double gain = GainOf(*other);
        if (gain <= best_gain) continue;
        best_gain = gain;
        best = std::move(other);
      }
      if (!best) return;
      *rule = std::move(*best);
    }
  }

  /// Rules that cover examples of the new one get the negation of one of its
  /// literals, if that is better than to drop them.
  void ProposeWith(const SearchRule& rule, const Propose& propose) {
    Proposal proposal{{}, {rule}};
    for (size_t i = 0; i < search_.rules().size(); ++i) {
      const SearchRule& old = search_.rules()[i];
      if (!old.covers.Meets(rule.covers)) continue;
      Proposal best = proposal;
      for (const int number : rule.context) {
        if (!IsOver(table_.feature(number), old.references)) continue;
        const int negated = table_.Number(table_.feature(number).Negated());
        auto narrower = search_.With(old, negated);
        if (!narrower) continue;
        Proposal other = proposal;
        other.removed.push_back(i);
        other.added.push_back(std::move(*narrower));
        if (search_.ScoreWith(other) > search_.ScoreWith(best)) best = other;
      }
      proposal = std::move(best);
    }
    propose(proposal);
  }

  bool IsOver(const Feature& feature, const References& references) const {
    return std::ranges::all_of(feature.terms, [&](int32_t term) {
      return term < table_.num_arguments() ||
             std::ranges::count(references, term) > 0;
    });
  }

  RuleSearch& search_;
  FeatureTable& table_;
  std::vector<int> examples_;
  std::vector<double> logs_;
};

}  // namespace

void ExplainExamples(RuleSearch& search, const Propose& propose) {
  std::vector<int> examples;
  search.Unexplained().ForEach([&](int e) { examples.push_back(e); });
  std::ranges::stable_sort(examples, std::less(), [&](int e) {
    return MixedNumber(search.options().seed ^
                       MixedNumber(static_cast<uint64_t>(e)));
  });
  Explanation explanation(search, examples);
  const double score = search.score();
  for (const int e : examples) {
    bool is_better = false;
    explanation.Explain(e, [&](const Proposal& proposal) {
      is_better |= search.ScoreWith(proposal) > score + 1e-6;
      propose(proposal);
    });
    if (is_better) return;  // the others may be explained by it, too
  }
}

}  // namespace cell::rules
