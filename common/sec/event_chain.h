#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/scene/key_frame.h"
#include "common/scene/relation.h"

namespace cell {

/// A semantic event chain (section V-B): rows are object pairs, in order,
/// columns are key frames, entries are relations. A value; how key frames come
/// about is no concern of this class.
class EventChain {
 public:
  /// No columns yet; the first one that is appended decides the rows.
  EventChain() = default;

  /// Appends the relations of a key frame as a column.
  /// @throws std::invalid_argument unless it has the pairs of the rows.
  void Append(const TouchGraph& relations);

  size_t num_rows() const { return pairs_.size(); }
  size_t num_columns() const { return num_columns_; }
  const std::vector<ObjectPair>& pairs() const { return pairs_; }
  /// @throws std::out_of_range.
  Relation At(size_t row, size_t column) const {
    return rows_.at(row).at(column);
  }
  /// One relation per column. @throws std::out_of_range.
  const std::vector<Relation>& Row(size_t row) const { return rows_.at(row); }
  std::optional<size_t> FindRow(const ObjectPair& pair) const;

  /// The columns from `first` up to, but without `end`.
  /// @throws std::out_of_range unless first <= end <= num_columns().
  EventChain Slice(size_t first, size_t end) const;
  /// The rows of pairs that `name` is one of.
  EventChain RowsOf(const std::string& name) const;
  /// The rows in which some entry differs from the first.
  EventChain ChangingRows() const;
  /// The columns that differ from the one before.
  EventChain DistinctColumns() const;

  bool operator==(const EventChain&) const = default;

 private:
  template <class Predicate>
  EventChain RowsWhere(Predicate is_wanted) const;

  std::vector<ObjectPair> pairs_;
  std::vector<std::vector<Relation>> rows_;
  size_t num_columns_ = 0;
};

/// All relations of the key frames, a column each. An unmodelled segment that
/// is not there at one is absent. @throws like EventChain::Append().
EventChain ChainOf(std::span<const KeyFrame> frames);

/// A line per row, with the codes of the relations (Fig. 12):
///
///   bolt, hand   0 1 1 0
///   bolt, table  1 1 0 1
std::string ToText(const EventChain& chain);

}  // namespace cell
