#pragma once

#include "common/sec/matrix_similarity.h"

namespace cell::cli {

/// A control that sees the sizes of chains only:
///
///   min(rows) / max(rows) * min(columns) / max(columns).
class SizeControl final : public MatrixSimilarity {
 private:
  double OfSorted(const RelationMatrix& a,
                  const RelationMatrix& b) const override;
};

}  // namespace cell::cli
