#include "common/assemblies/order_evidence.h"

#include <algorithm>
#include <iterator>

namespace cell::assemblies {
namespace {

constexpr double kUndoneWeight = 0.3;  // of a correct attach undone later

std::set<PartPair> PairsOf(std::span<const AssemblySequence* const> sequences) {
  std::set<PartPair> pairs;
  for (const AssemblySequence* sequence : sequences) {
    for (const AssemblyAction& action : sequence->actions) {
      pairs.insert(action.pair);
    }
  }
  return pairs;
}

std::set<PartPair> Intersection(const std::set<PartPair>& a,
                                const std::set<PartPair>& b) {
  std::set<PartPair> both;
  std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
  return both;
}

class Collector {
 public:
  explicit Collector(std::set<PartPair> pairs) : pairs_(std::move(pairs)) {}

  void Add(const AssemblySequence& sequence) {
    std::map<PartPair, size_t> last_detach;
    for (size_t i = 0; i < sequence.actions.size(); ++i) {
      const AssemblyAction& action = sequence.actions[i];
      if (action.verb == Verb::kDetach) last_detach[action.pair] = i;
    }
    std::set<PartPair> attached;
    for (size_t i = 0; i < sequence.actions.size(); ++i) {
      const AssemblyAction& action = sequence.actions[i];
      if (action.verb == Verb::kDetach) {
        attached.erase(action.pair);
        continue;
      }
      const auto it = last_detach.find(action.pair);
      AddAttach(action, attached, it == last_detach.end() || it->second < i);
      attached.insert(action.pair);
    }
  }

  OrderEvidence Release() { return std::move(evidence_); }

 private:
  void AddAttach(const AssemblyAction& action,
                 const std::set<PartPair>& attached, bool is_durable) {
    PairCount& pair = evidence_.pairs[action.pair];
    const bool is_correct = action.label == Label::kCorrect;
    const bool is_wrong = action.kind == MistakeKind::kWrongOrder;
    pair.num_correct += is_correct;
    pair.num_wrong_order += is_wrong;
    pair.num_wrong_position += action.kind == MistakeKind::kWrongPosition;
    if (is_correct && is_durable) {
      pair.before_durable = pair.has_durable
                                ? Intersection(pair.before_durable, attached)
                                : attached;
      pair.has_durable = true;
    }
    if (!is_correct && !is_wrong) return;
    const double weight = is_wrong || is_durable ? 1 : kUndoneWeight;
    for (const PartPair& missing : pairs_) {
      if (missing == action.pair || attached.contains(missing)) continue;
      OrderCount& count = evidence_.counts[{action.pair, missing}];
      (is_wrong ? count.num_wrong : count.num_correct) += weight;
    }
  }

  std::set<PartPair> pairs_;
  OrderEvidence evidence_;
};

}  // namespace

OrderEvidence CollectEvidence(
    std::span<const AssemblySequence* const> sequences) {
  Collector collector(PairsOf(sequences));
  for (const AssemblySequence* sequence : sequences) collector.Add(*sequence);
  return collector.Release();
}

void OrderPrior::AddWithSign(const OrderEvidence& toy, int sign) {
  for (const auto& [key, count] : toy.counts) {
    OrderCount& sum = counts_[key];
    sum.num_wrong += count.num_wrong > 0 ? sign : 0;
    sum.num_correct += count.num_correct > 0 ? sign : 0;
  }
}

OrderCount OrderPrior::At(const PartPair& attached,
                          const PartPair& missing) const {
  const auto it = counts_.find({attached, missing});
  return it == counts_.end() ? OrderCount{} : it->second;
}

}  // namespace cell::assemblies
