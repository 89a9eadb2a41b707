#include "services/cell/evaluations/pair_orders.h"

#include <algorithm>
#include <map>

namespace cell::cli {
namespace {

using assemblies::AssemblyAction;
using assemblies::AssemblySequence;
using assemblies::Label;
using assemblies::PartPair;
using assemblies::Verb;

using Orders = std::set<std::pair<PartPair, PartPair>>;

/// (before, after) of all correct attaches.
Orders SeenOrders(const std::vector<const AssemblySequence*>& training) {
  Orders orders;
  for (const AssemblySequence* sequence : training) {
    std::vector<PartPair> earlier;
    for (const AssemblyAction& action : sequence->actions) {
      if (action.verb != Verb::kAttach || action.label != Label::kCorrect) {
        continue;
      }
      for (const PartPair& pair : earlier) orders.insert({pair, action.pair});
      earlier.push_back(action.pair);
    }
  }
  return orders;
}

}  // namespace

std::vector<Label> JudgeByPairOrders(
    const std::vector<const AssemblySequence*>& training,
    const AssemblySequence& judged) {
  const Orders orders = SeenOrders(training);
  std::map<PartPair, bool> is_flagged;  // of what stands
  std::vector<Label> verdicts;
  for (const AssemblyAction& action : judged.actions) {
    const PartPair& pair = action.pair;
    if (action.verb == Verb::kDetach) {
      const auto it = is_flagged.find(pair);
      const bool is_correction = it != is_flagged.end() && it->second;
      verdicts.push_back(is_correction ? Label::kCorrection : Label::kMistake);
      is_flagged.erase(pair);
      continue;
    }
    const bool is_mistake = std::ranges::any_of(is_flagged, [&](const auto& s) {
      return orders.contains({pair, s.first}) &&
             !orders.contains({s.first, pair});
    });
    verdicts.push_back(is_mistake ? Label::kMistake : Label::kCorrect);
    is_flagged[pair] = is_mistake;
  }
  return verdicts;
}

}  // namespace cell::cli
