#pragma once

#include "common/sec/matrix_similarity.h"

namespace cell {

/// As JointSimilarity, but only rows of one role correspond. Roles are pairs of
/// types of objects, which the constructor is given: of event chains, rows of
/// (hand, bolt_1) and (hand, bolt_2) have one role if both bolts are of one
/// type. Without types, rows correspond where their pairs have the same names.
class TypedSimilarity final : public MatrixSimilarity {
 public:
  using MatrixSimilarity::MatrixSimilarity;

 private:
  double OfSorted(const RelationMatrix& a,
                  const RelationMatrix& b) const override;
};

}  // namespace cell
