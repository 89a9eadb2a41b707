#pragma once

#include "common/sec/matrix_similarity.h"

namespace cell {

/// The similarity of section VI-A ([11]), as far as the paper's text settles
/// it. Rows correspond one to one so that the sum of
///
///   theta(i, j) = LCS(row_i, row_j) / max(length_i, length_j)
///
/// is largest, LCS being the length of the longest common subsequence; rows
/// left over are noise. With the set R of the corresponding rows,
///
///   theta(u, v) = |{(i, j) in R : a_iu = b_jv}| / |R|
///   similarity  = max over monotone alignments C of
///                 sum_{(u, v) in C} theta(u, v) / max(columns_a, columns_b).
///
/// Roles make no difference.
class PaperSimilarity final : public MatrixSimilarity {
 public:
  using MatrixSimilarity::MatrixSimilarity;

 private:
  double OfSorted(const RelationMatrix& a,
                  const RelationMatrix& b) const override;
};

}  // namespace cell
