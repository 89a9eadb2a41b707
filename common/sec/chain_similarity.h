#pragma once

#include "common/sec/event_chain.h"

namespace cell {

/// How alike two event chains are: a measure of its own behind one interface.
class ChainSimilarity {
 public:
  ChainSimilarity() = default;
  ChainSimilarity(const ChainSimilarity&) = delete;
  ChainSimilarity& operator=(const ChainSimilarity&) = delete;
  virtual ~ChainSimilarity() = default;

  /// From 0 to 1, which a chain has with itself. Symmetric.
  virtual double Between(const EventChain& a, const EventChain& b) const = 0;
};

}  // namespace cell
