#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/sec/chain_similarity.h"

namespace cell {

/// Of all measures that there are, sorted.
std::vector<std::string> ChainSimilarityNames();
/// nullptr if there is none of that name.
std::unique_ptr<ChainSimilarity> MakeChainSimilarity(const std::string& name);

}  // namespace cell
