#pragma once

#include "common/sec/chain_similarity.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// A similarity that looks at relations and roles of rows, not at names. The
/// order of the rows of either chain makes no difference. Chains without
/// entries are alike (1) if both have none, and otherwise have nothing in
/// common (0).
class MatrixSimilarity : public ChainSimilarity {
 public:
  /// `types` give the roles of rows of event chains (RoleTable); without them
  /// each object is a type of its own.
  explicit MatrixSimilarity(ObjectTypes types = {})
      : types_(std::move(types)) {}

  double Between(const EventChain& a, const EventChain& b) const final;
  /// Of matrices whose roles one table has numbered.
  double Between(const RelationMatrix& a, const RelationMatrix& b) const;

 private:
  /// Both have entries; `a` is not greater than `b`.
  virtual double OfSorted(const RelationMatrix& a,
                          const RelationMatrix& b) const = 0;

  ObjectTypes types_;
};

}  // namespace cell
