#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "common/sec/relation_matrix.h"

namespace cell {

/// The noise of the experiments of section VI-A (Fig. 12).
struct ChainNoise {
  /// p: of an entry to change, and of a row or column to be inserted.
  double probability = 0;
  bool flips_entries = true;  ///< false: only inserts rows and columns
  /// Roles that inserted rows draw from; empty: the roles of the chain's rows.
  std::vector<uint32_t> roles;
};

/// A noisy sample of `chain`:
///
/// 1. each entry changes with probability p to one of the other three;
/// 2. each of the R - 1 gaps between rows receives a row with probability p;
/// 3. each of the C - 1 gaps between columns receives a column with
///    probability p, which is as long as there are rows now;
/// 4. the rows are put in random order.
///
/// Entries of inserted rows and columns are drawn from the four relations.
RelationMatrix WithNoise(const RelationMatrix& chain, const ChainNoise& noise,
                         std::mt19937_64& random);

/// A chain whose entries are drawn from the four relations so that each row
/// changes and no column repeats the one before. @throws std::invalid_argument
/// for fewer than two columns.
RelationMatrix RandomChain(const std::vector<uint32_t>& roles,
                           size_t num_columns, std::mt19937_64& random);

/// Below `bound`, which is not 0.
size_t DrawBelow(size_t bound, std::mt19937_64& random);

}  // namespace cell
