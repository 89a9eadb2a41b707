#pragma once

#include "common/sec/matrix_similarity.h"

namespace cell {

/// Aligns rows and columns jointly (AlignChains): whichever rows make the
/// columns agree best, and the other way round. With the number E of equal
/// entries in rows and columns that correspond,
///
///   similarity = 2 E / (rows_a columns_a + rows_b columns_b),
///
/// so that rows and columns left over count as different. Roles make no
/// difference.
class JointSimilarity final : public MatrixSimilarity {
 public:
  using MatrixSimilarity::MatrixSimilarity;

 private:
  double OfSorted(const RelationMatrix& a,
                  const RelationMatrix& b) const override;
};

}  // namespace cell
