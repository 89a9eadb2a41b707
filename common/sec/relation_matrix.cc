#include "common/sec/relation_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

namespace cell {
namespace {

constexpr std::array<Relation, RelationMatrix::kNumSymbols> kRelations = {
    Relation::kNotTouching, Relation::kTouching, Relation::kOverlapping,
    Relation::kAbsent};

}  // namespace

std::string RoleTable::TypeOf(const std::string& name) const {
  const auto it = types_.find(name);
  return it == types_.end() ? name : it->second;
}

uint32_t RoleTable::RoleOf(const ObjectPair& pair) {
  const auto next = static_cast<uint32_t>(numbers_.size());
  const ObjectPair types = MakePair(TypeOf(pair.first), TypeOf(pair.second));
  return numbers_.emplace(types, next).first->second;
}

uint8_t SymbolOf(Relation relation) {
  const auto it = std::ranges::find(kRelations, relation);
  return static_cast<uint8_t>(it - kRelations.begin());
}

Relation RelationOf(uint8_t symbol) {
  return kRelations.at(symbol);
}

RelationMatrix::RelationMatrix(std::vector<uint32_t> roles, size_t num_columns)
    : num_columns_(num_columns), roles_(std::move(roles)) {
  if (num_rows() > kMaxSize || num_columns > kMaxSize) {
    throw std::invalid_argument(
        fmt::format("an event chain of {} rows and {} columns; at most {} each",
                    num_rows(), num_columns, kMaxSize));
  }
  symbols_.resize(num_rows() * num_columns);
}

RelationMatrix::RelationMatrix(const EventChain& chain, RoleTable* roles)
    : RelationMatrix(std::vector<uint32_t>(chain.num_rows()),
                     chain.num_columns()) {
  for (size_t row = 0; row < num_rows(); ++row) {
    roles_[row] = roles->RoleOf(chain.pairs()[row]);
    std::ranges::transform(chain.Row(row), &symbols_[row * num_columns_],
                           SymbolOf);
  }
}

RelationMatrix RelationMatrix::Select(std::span<const size_t> rows,
                                      std::span<const size_t> columns) const {
  std::vector<uint32_t> roles;
  for (const size_t row : rows) roles.push_back(roles_[row]);
  RelationMatrix chosen(std::move(roles), columns.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    for (size_t j = 0; j < columns.size(); ++j) {
      chosen.Set(i, j, Symbol(rows[i], columns[j]));
    }
  }
  return chosen;
}

RelationMatrix RelationMatrix::Sorted() const {
  std::vector<size_t> rows(num_rows());
  std::vector<size_t> columns(num_columns());
  std::iota(rows.begin(), rows.end(), size_t{0});
  std::iota(columns.begin(), columns.end(), size_t{0});
  std::ranges::stable_sort(rows,
                           [&](size_t a, size_t b) { return IsBefore(a, b); });
  return Select(rows, columns);
}

bool RelationMatrix::IsSorted() const {
  for (size_t row = 1; row < num_rows(); ++row) {
    if (IsBefore(row, row - 1)) return false;
  }
  return true;
}

bool RelationMatrix::IsBefore(size_t row_a, size_t row_b) const {
  if (roles_[row_a] != roles_[row_b]) return roles_[row_a] < roles_[row_b];
  return std::ranges::lexicographical_compare(Row(row_a), Row(row_b));
}

RelationMatrix RelationMatrix::Changing() const {
  std::vector<size_t> rows;
  for (size_t row = 0; row < num_rows(); ++row) {
    const auto symbols = Row(row);
    const auto differs = [&](uint8_t s) {
      return s != symbols.front();
    };
    if (std::ranges::any_of(symbols, differs)) rows.push_back(row);
  }
  std::vector<size_t> columns;
  for (size_t column = 0; column < num_columns(); ++column) {
    const auto changes = [&](size_t row) {
      return Symbol(row, column) != Symbol(row, column - 1);
    };
    if (column == 0 || std::ranges::any_of(rows, changes)) {
      columns.push_back(column);
    }
  }
  return Select(rows, columns);
}

std::string ToText(const RelationMatrix& matrix) {
  std::string text;
  for (size_t row = 0; row < matrix.num_rows(); ++row) {
    for (const uint8_t symbol : matrix.Row(row)) {
      text += fmt::format(" {}", static_cast<int>(RelationOf(symbol)));
    }
    text += '\n';
  }
  return text;
}

}  // namespace cell
