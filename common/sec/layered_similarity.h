#pragma once

#include <utility>

#include "common/sec/chain_alignment.h"
#include "common/sec/layered_chain.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// How alike enriched event chains are. Rows and columns are aligned by
/// touching (AlignChains); what corresponds is compared in each layer. With the
/// numbers E_l of equal entries in the layers l that are compared, L of them,
///
///   similarity = 2 sum_l E_l / (L (rows_a columns_a + rows_b columns_b)),
///
/// which is JointSimilarity or TypedSimilarity if only touching is compared.
class LayeredSimilarity {
 public:
  struct Params {
    RowRoles roles = RowRoles::kKept;  ///< which rows may correspond
    ObjectTypes types;                 ///< that give rows their roles
    bool has_places = true;            ///< compares static relations, too
    bool has_motions = true;           ///< compares dynamic relations, too
  };

  explicit LayeredSimilarity(Params params) : params_(std::move(params)) {}

  /// From 0 to 1, which a chain has with itself. Symmetric. Chains without
  /// entries are alike (1) if both have none, and otherwise have nothing in
  /// common (0).
  double Between(const LayeredChain& a, const LayeredChain& b) const;

 private:
  Params params_;
};

}  // namespace cell
