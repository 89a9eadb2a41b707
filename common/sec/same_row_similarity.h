#pragma once

#include "common/sec/chain_similarity.h"

namespace cell {

/// The share of all rows, of either chain, whose pairs both have with the same
/// sequence of distinct relations: how long a relation lasts, and what happens
/// meanwhile elsewhere, counts for nothing.
class SameRowSimilarity final : public ChainSimilarity {
 public:
  double Between(const EventChain& a, const EventChain& b) const override;
};

}  // namespace cell
