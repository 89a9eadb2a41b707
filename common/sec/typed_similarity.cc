#include "common/sec/typed_similarity.h"

#include "common/sec/chain_alignment.h"

namespace cell {

double TypedSimilarity::OfSorted(const RelationMatrix& a,
                                 const RelationMatrix& b) const {
  return DiceOf(AlignChains(a, b, RowRoles::kKept), a, b);
}

}  // namespace cell
