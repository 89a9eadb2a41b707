#include "common/sec/chain_similarities.h"

#include <map>

#include "common/sec/derivative_similarity.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/paper_similarity.h"
#include "common/sec/same_pair_similarity.h"
#include "common/sec/same_row_similarity.h"
#include "common/sec/typed_similarity.h"
#include "common/text/nearest.h"

namespace cell {
namespace {

using Maker = std::unique_ptr<ChainSimilarity> (*)();

template <class Similarity>
std::unique_ptr<ChainSimilarity> Make() {
  return std::make_unique<Similarity>();
}

const std::map<std::string, Maker>& Makers() {
  static const std::map<std::string, Maker> makers = {
      {"derivative", Make<DerivativeSimilarity>},
      {"joint", Make<JointSimilarity>},
      {"paper", Make<PaperSimilarity>},
      {"same_pair", Make<SamePairSimilarity>},
      {"same_row", Make<SameRowSimilarity>},
      {"typed", Make<TypedSimilarity>}};
  return makers;
}

}  // namespace

std::vector<std::string> ChainSimilarityNames() {
  return KeysOf(Makers());
}

std::unique_ptr<ChainSimilarity> MakeChainSimilarity(const std::string& name) {
  const auto it = Makers().find(name);
  return it == Makers().end() ? nullptr : it->second();
}

}  // namespace cell
