#include "common/sec/joint_similarity.h"

#include "common/sec/chain_alignment.h"

namespace cell {

double JointSimilarity::OfSorted(const RelationMatrix& a,
                                 const RelationMatrix& b) const {
  return DiceOf(AlignChains(a, b, RowRoles::kIgnored), a, b);
}

}  // namespace cell
