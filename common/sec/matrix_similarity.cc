#include "common/sec/matrix_similarity.h"

#include <set>

namespace cell {

double MatrixSimilarity::Between(const EventChain& a,
                                 const EventChain& b) const {
  RoleTable roles(types_);
  // Numbered alike whichever chain comes first.
  std::set<ObjectPair> pairs(a.pairs().begin(), a.pairs().end());
  pairs.insert(b.pairs().begin(), b.pairs().end());
  for (const ObjectPair& pair : pairs) roles.RoleOf(pair);
  const RelationMatrix matrix_a(a, &roles);
  return Between(matrix_a, RelationMatrix(b, &roles));
}

double MatrixSimilarity::Between(const RelationMatrix& a,
                                 const RelationMatrix& b) const {
  if (a.is_empty() || b.is_empty()) return a.is_empty() == b.is_empty();
  if (!a.IsSorted()) return Between(a.Sorted(), b);
  if (!b.IsSorted()) return Between(a, b.Sorted());
  return a <= b ? OfSorted(a, b) : OfSorted(b, a);
}

}  // namespace cell
