#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/sec/event_chain.h"

namespace cell {

/// Types of objects by name; an object that is not listed is a type of its own.
using ObjectTypes = std::map<std::string, std::string>;

/// Numbers the roles of rows. A role is the unordered pair of the types of a
/// row's objects, so that rows of objects of the same types have one role.
/// Matrices can be compared by role if one table numbered them.
class RoleTable {
 public:
  explicit RoleTable(ObjectTypes types = {}) : types_(std::move(types)) {}

  /// The number of the role of `pair`; a new role gets the next number.
  uint32_t RoleOf(const ObjectPair& pair);

 private:
  std::string TypeOf(const std::string& name) const;

  ObjectTypes types_;
  std::map<ObjectPair, uint32_t> numbers_;
};

/// The relations of an event chain without names: each row has a role and one
/// symbol per column. A value. Symbols 0 to 3 stand for the relations with the
/// codes 0, 1, 2 and 9.
class RelationMatrix {
 public:
  static constexpr int kNumSymbols = 4;
  /// Of rows, and of columns: equal entries are counted in 16 bits.
  static constexpr size_t kMaxSize = 4096;

  RelationMatrix() = default;
  /// A row per role, of kNotTouching. @throws std::invalid_argument for more
  /// than kMaxSize rows or columns.
  RelationMatrix(std::vector<uint32_t> roles, size_t num_columns);
  /// @throws std::invalid_argument as above.
  RelationMatrix(const EventChain& chain, RoleTable* roles);

  size_t num_rows() const { return roles_.size(); }
  size_t num_columns() const { return num_columns_; }
  size_t num_entries() const { return symbols_.size(); }
  bool is_empty() const { return symbols_.empty(); }
  uint32_t role(size_t row) const { return roles_[row]; }
  const std::vector<uint32_t>& roles() const { return roles_; }

  uint8_t Symbol(size_t row, size_t column) const {
    return symbols_[row * num_columns_ + column];
  }
  std::span<const uint8_t> Row(size_t row) const {
    return {symbols_.data() + row * num_columns_, num_columns_};
  }
  void Set(size_t row, size_t column, uint8_t symbol) {
    symbols_[row * num_columns_ + column] = symbol;
  }

  /// These rows and columns, in this order; each may occur more than once.
  RelationMatrix Select(std::span<const size_t> rows,
                        std::span<const size_t> columns) const;
  /// Rows sorted by role, then by their symbols: the same for any order of the
  /// rows.
  RelationMatrix Sorted() const;
  bool IsSorted() const;
  /// Without rows that never change and columns that repeat the one before.
  RelationMatrix Changing() const;

  auto operator<=>(const RelationMatrix&) const = default;

 private:
  bool IsBefore(size_t row_a, size_t row_b) const;

  size_t num_columns_ = 0;
  std::vector<uint32_t> roles_;
  std::vector<uint8_t> symbols_;  // by rows
};

uint8_t SymbolOf(Relation relation);
Relation RelationOf(uint8_t symbol);

/// A line per row, with the codes of the relations.
std::string ToText(const RelationMatrix& matrix);

}  // namespace cell
