#pragma once

#include <random>
#include <string>
#include <vector>

#include "common/sec/chain_noise.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// A matrix of relation codes, a string per row: {"9019", "1101"}. Row i has
/// role i unless `roles` are given.
inline RelationMatrix MatrixOf(const std::vector<std::string>& rows,
                               std::vector<uint32_t> roles = {}) {
  for (uint32_t row = 0; roles.size() < rows.size(); ++row) {
    roles.push_back(row);
  }
  RelationMatrix matrix(std::move(roles), rows.front().size());
  for (size_t i = 0; i < rows.size(); ++i) {
    for (size_t j = 0; j < rows[i].size(); ++j) {
      const auto code = static_cast<int8_t>(rows[i][j] - '0');
      matrix.Set(i, j, SymbolOf(RelationFromCode(code).value()));
    }
  }
  return matrix;
}

/// Of a size from 1x2 to 6x9, with roles below 4.
inline RelationMatrix RandomMatrix(std::mt19937_64& random) {
  std::vector<uint32_t> roles(1 + DrawBelow(6, random));
  for (uint32_t& role : roles) {
    role = static_cast<uint32_t>(DrawBelow(4, random));
  }
  return RandomChain(roles, 2 + DrawBelow(8, random), random);
}

}  // namespace cell
