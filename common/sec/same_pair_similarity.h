#pragma once

#include "common/sec/chain_similarity.h"

namespace cell {

/// Similarity of chains whose rows correspond where their pairs have the same
/// names: two columns are as alike as the share of all rows, of either chain,
/// that both have with the same entry; columns are aligned in their order so
/// that the sum is largest; it is divided by the larger number of columns.
/// Chains without rows or columns are alike if both are.
///
/// Cost: rows times the product of the numbers of columns.
class SamePairSimilarity final : public ChainSimilarity {
 public:
  double Between(const EventChain& a, const EventChain& b) const override;
};

}  // namespace cell
