#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>

#include "common/assemblies/annotation.h"

namespace cell::assemblies {

/// Attaches of a pair, seen while another pair was not attached.
struct OrderCount {
  double num_wrong = 0;    ///< called a wrong order
  double num_correct = 0;  ///< called correct
};
/// By (attached pair, missing pair).
using OrderCounts = std::map<std::pair<PartPair, PartPair>, OrderCount>;

/// What is seen of one pair's attaches.
struct PairCount {
  int num_correct = 0;
  int num_wrong_order = 0;
  int num_wrong_position = 0;
  bool has_durable = false;
  /// Attached before every durable attach: correct, and never undone.
  std::set<PartPair> before_durable;
};

/// What sequences of one toy say of the order of its attaches.
struct OrderEvidence {
  std::map<PartPair, PairCount> pairs;
  OrderCounts counts;
};

/// A correct attach that is undone later counts less than one: it may have been
/// undone because it was too early.
OrderEvidence CollectEvidence(
    std::span<const AssemblySequence* const> sequences);

/// In how many toys an attach while another pair was missing was ever called a
/// wrong order, and ever correct. Parts of one name do like jobs in many toys,
/// so that this is the prior of a toy of which little was seen.
class OrderPrior {
 public:
  void Add(const OrderEvidence& toy) { AddWithSign(toy, 1); }
  /// Takes back what Add() added: the prior of a toy is what the others say.
  void Remove(const OrderEvidence& toy) { AddWithSign(toy, -1); }
  OrderCount At(const PartPair& attached, const PartPair& missing) const;

 private:
  void AddWithSign(const OrderEvidence& toy, int sign);
  OrderCounts counts_;
};

}  // namespace cell::assemblies
