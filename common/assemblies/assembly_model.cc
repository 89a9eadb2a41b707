#include "common/assemblies/assembly_model.h"

#include <algorithm>
#include <functional>

namespace cell::assemblies {
namespace {

// Means of beta distributions: the weight of what is expected beforehand, in
// observations. Among the pairs of a toy few are preconditions of each other.
constexpr double kPriorWeight = 1;
constexpr double kExpectationWeight = 0.5;
constexpr double kExpectation = 0.05;

double WrongOrderProbability(const OrderCount& own, const OrderCount& others) {
  const double prior =
      (others.num_wrong + kExpectationWeight * kExpectation) /
      (others.num_wrong + others.num_correct + kExpectationWeight);
  return (own.num_wrong + kPriorWeight * prior) /
         (own.num_wrong + own.num_correct + kPriorWeight);
}

class ModelBuilder {
 public:
  ModelBuilder(const OrderEvidence& toy, const OrderPrior& others,
               const JudgeSettings& settings)
      : toy_(toy), others_(others), settings_(settings) {}

  AssemblyModel Build() {
    DeclareSymbols();
    for (const auto& [pair, count] : toy_.pairs) {
      if (count.num_correct > 0) {
        model_.goal.insert(pair);
        model_.parts.insert({pair.first, pair.second});
      }
    }
    ChoosePreconditions();
    for (const auto& [pair, count] : toy_.pairs) {
      model_.rule_of[pair] = static_cast<int>(model_.rules.rules.size());
      model_.rules.rules.push_back(RuleOf(pair, count));
    }
    return std::move(model_);
  }

 private:
  void DeclareSymbols() {
    std::string text;
    std::set<std::string> parts;
    for (const auto& [pair, count] : toy_.pairs) {
      parts.insert({pair.first, pair.second});
      text += ActionName(pair) + " 0 action\n";
    }
    text += "joined 2 primitive\nmisplaced 2 primitive\n";
    for (const std::string& part : parts) text += part + " 0 constant\n";
    auto table = rules::SymbolTable::Parse(text, "the rules of an assembly");
    joined_ = *table.Find("joined");
    misplaced_ = *table.Find("misplaced");
    model_.rules.symbols =
        std::make_shared<const rules::SymbolTable>(std::move(table));
  }

  static std::string ActionName(const PartPair& pair) {
    return "attach_" + pair.first + "__" + pair.second;
  }

  rules::Literal LiteralOf(int symbol, const PartPair& pair) const {
    rules::Literal literal{symbol, {}, rules::Comparison::kTrue, 0};
    const auto& constants = model_.rules.symbols->constants();
    for (const std::string& part : {pair.first, pair.second}) {
      const auto it = std::ranges::find(constants, part);
      literal.terms.push_back({rules::Term::Kind::kObject,
                               static_cast<int>(it - constants.begin())});
    }
    return literal;
  }

  struct Candidate {
    double probability;
    PartPair pair;
    PartPair required;
  };

  /// That `pair` is a wrong order while `other` is missing; 0 if it ever was
  /// attached to stay without that.
  double ProbabilityOf(const PartPair& pair, const PairCount& count,
                       const PartPair& other) const {
    if (count.has_durable && !count.before_durable.contains(other)) return 0;
    const auto it = toy_.counts.find({pair, other});
    const OrderCount own = it == toy_.counts.end() ? OrderCount{} : it->second;
    return WrongOrderProbability(own, others_.At(pair, other));
  }

  std::vector<Candidate> Candidates() const {
    std::vector<Candidate> candidates;
    for (const auto& [pair, count] : toy_.pairs) {
      // Two parts of one name may be any two of several: nothing is required.
      if (pair.is_of_one_name()) continue;
      for (const PartPair& other : model_.goal) {
        if (other == pair) continue;
        const double probability = ProbabilityOf(pair, count, other);
        if (probability >= settings_.least_probability) {
          candidates.push_back({probability, pair, other});
        }
      }
    }
    std::ranges::stable_sort(candidates, std::greater{},
                             &Candidate::probability);
    return candidates;
  }

  void ChoosePreconditions() {
    for (const Candidate& candidate : Candidates()) {
      if (!IsRequiredBy(candidate.pair, candidate.required)) {
        required_[candidate.pair].insert(candidate.required);
      }
    }
  }

  /// True if `late` requires `early`, or something that does.
  bool IsRequiredBy(const PartPair& early, const PartPair& late) const {
    if (early == late) return true;
    const auto it = required_.find(late);
    return it != required_.end() &&
           std::ranges::any_of(it->second, [&](const PartPair& required) {
             return IsRequiredBy(early, required);
           });
  }

  rules::Rule RuleOf(const PartPair& pair, const PairCount& count) const {
    rules::Rule rule;
    rule.action = *model_.rules.symbols->Find(ActionName(pair));
    if (const auto it = required_.find(pair); it != required_.end()) {
      for (const PartPair& other : it->second) {
        rule.context.push_back(LiteralOf(joined_, other));
      }
    }
    const double all = count.num_correct + count.num_wrong_position + 2;
    const double misplaced = count.num_wrong_position / all;
    rule.outcomes.push_back(
        {(count.num_correct + 1) / all, {LiteralOf(joined_, pair)}});
    if (misplaced > 0) {
      rule.outcomes.push_back({misplaced, {LiteralOf(misplaced_, pair)}});
    }
    rule.noise = 1 / all;
    return rule;
  }

  const OrderEvidence& toy_;
  const OrderPrior& others_;
  JudgeSettings settings_;
  AssemblyModel model_;
  std::map<PartPair, std::set<PartPair>> required_;  // without a cycle
  int joined_ = 0;
  int misplaced_ = 0;
};

}  // namespace

AssemblyModel LearnModel(const OrderEvidence& toy, const OrderPrior& others,
                         const JudgeSettings& settings) {
  return ModelBuilder(toy, others, settings).Build();
}

PartPair PairOf(const rules::Literal& literal, const rules::NdrRules& rules) {
  const auto& constants = rules.symbols->constants();
  const auto part = [&](size_t i) -> const std::string& {
    return constants.at(static_cast<size_t>(literal.terms.at(i).index));
  };
  return {part(0), part(1)};
}

}  // namespace cell::assemblies
