#pragma once

#include "common/sec/matrix_similarity.h"

namespace cell {

/// The similarity of section VI-A ([11]), read as one of derivative chains.
/// The derivative of a chain has a column fewer; its entries are the pairs of
/// a row's relations in two columns that follow each other. Without the pairs
/// of equal relations, a row's entries are its changes d_i. Rows are compared
/// by sub-string search,
///
///   theta(i, j) = max over shifts s of |{k : d_i[k] = d_j[k + s]}|
///                 / max(|d_i|, |d_j|)    (1 if neither row changes),
///
/// the shorter one shifted along the longer one, and correspond one to one so
/// that the sum is largest. Columns of the derivative chains are aligned in
/// their order as in PaperSimilarity, with the share of corresponding rows with
/// equal entries, and so is the result. A chain of one column counts as one
/// whose relations stay.
class DerivativeSimilarity final : public MatrixSimilarity {
 public:
  using MatrixSimilarity::MatrixSimilarity;

 private:
  double OfSorted(const RelationMatrix& a,
                  const RelationMatrix& b) const override;
};

}  // namespace cell
