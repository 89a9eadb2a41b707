#include "common/sec/chain_noise.h"

#include <algorithm>
#include <stdexcept>

namespace cell {
namespace {

bool DrawWith(double probability, std::mt19937_64& random) {
  constexpr double kUnit = 0x1p-53;
  return static_cast<double>(random() >> 11) * kUnit < probability;
}

uint8_t DrawSymbol(std::mt19937_64& random) {
  return static_cast<uint8_t>(DrawBelow(RelationMatrix::kNumSymbols, random));
}

uint8_t OtherSymbol(uint8_t symbol, std::mt19937_64& random) {
  const size_t step = 1 + DrawBelow(RelationMatrix::kNumSymbols - 1, random);
  return static_cast<uint8_t>((symbol + step) % RelationMatrix::kNumSymbols);
}

constexpr size_t kInserted = SIZE_MAX;

// The lines of a noisy chain: of the original, or kInserted.
std::vector<size_t> LinesWithNoise(size_t num_lines, double probability,
                                   std::mt19937_64& random) {
  std::vector<size_t> lines;
  for (size_t line = 0; line < num_lines; ++line) {
    if (line > 0 && DrawWith(probability, random)) lines.push_back(kInserted);
    lines.push_back(line);
  }
  return lines;
}

void Shuffle(std::vector<size_t>* lines, std::mt19937_64& random) {
  for (size_t i = lines->size(); i > 1; --i) {
    std::swap((*lines)[i - 1], (*lines)[DrawBelow(i, random)]);
  }
}

RelationMatrix WithFlips(RelationMatrix chain, double probability,
                         std::mt19937_64& random) {
  for (size_t row = 0; row < chain.num_rows(); ++row) {
    for (size_t column = 0; column < chain.num_columns(); ++column) {
      if (!DrawWith(probability, random)) continue;
      chain.Set(row, column, OtherSymbol(chain.Symbol(row, column), random));
    }
  }
  return chain;
}

}  // namespace

size_t DrawBelow(size_t bound, std::mt19937_64& random) {
  return static_cast<size_t>(random() % bound);
}

RelationMatrix WithNoise(const RelationMatrix& chain, const ChainNoise& noise,
                         std::mt19937_64& random) {
  const double p = noise.probability;
  const RelationMatrix original =
      noise.flips_entries ? WithFlips(chain, p, random) : chain;
  auto rows = LinesWithNoise(chain.num_rows(), p, random);
  const auto columns = LinesWithNoise(chain.num_columns(), p, random);
  Shuffle(&rows, random);
  const auto& noise_roles = noise.roles.empty() ? chain.roles() : noise.roles;
  std::vector<uint32_t> roles;
  for (const size_t row : rows) {
    roles.push_back(row == kInserted
                        ? noise_roles[DrawBelow(noise_roles.size(), random)]
                        : chain.role(row));
  }
  RelationMatrix noisy(std::move(roles), columns.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    for (size_t j = 0; j < columns.size(); ++j) {
      const bool is_inserted = rows[i] == kInserted || columns[j] == kInserted;
      noisy.Set(i, j,
                is_inserted ? DrawSymbol(random)
                            : original.Symbol(rows[i], columns[j]));
    }
  }
  return noisy;
}

RelationMatrix RandomChain(const std::vector<uint32_t>& roles,
                           size_t num_columns, std::mt19937_64& random) {
  if (num_columns < 2) {
    throw std::invalid_argument(
        "a chain of one column has no row that changes");
  }
  RelationMatrix chain(roles, num_columns);
  do {
    for (size_t row = 0; row < roles.size(); ++row) {
      for (size_t column = 0; column < num_columns; ++column) {
        chain.Set(row, column, DrawSymbol(random));
      }
    }
  } while (chain.Changing() != chain);
  return chain;
}

}  // namespace cell
