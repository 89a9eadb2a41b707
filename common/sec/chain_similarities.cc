#include "common/sec/chain_similarities.h"

#include "common/sec/same_pair_similarity.h"
#include "common/sec/same_row_similarity.h"

namespace cell {

std::vector<std::string> ChainSimilarityNames() {
  return {"same_pair", "same_row"};
}

std::unique_ptr<ChainSimilarity> MakeChainSimilarity(const std::string& name) {
  if (name == "same_pair") return std::make_unique<SamePairSimilarity>();
  if (name == "same_row") return std::make_unique<SameRowSimilarity>();
  return nullptr;
}

}  // namespace cell
