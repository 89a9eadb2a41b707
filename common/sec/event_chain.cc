#include "common/sec/event_chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cell {

void EventChain::Append(const TouchGraph& relations) {
  if (num_columns_ == 0) {
    for (const auto& [pair, relation] : relations) pairs_.push_back(pair);
    rows_.resize(pairs_.size());
  }
  const bool has_rows = std::equal(
      pairs_.begin(), pairs_.end(), relations.begin(), relations.end(),
      [](const auto& pair, const auto& entry) { return pair == entry.first; });
  if (!has_rows) {
    throw std::invalid_argument(
        fmt::format("a column of {} pairs for a chain of other {} pairs",
                    relations.size(), pairs_.size()));
  }
  size_t row = 0;
  for (const auto& [pair, relation] : relations) {
    rows_[row++].push_back(relation);
  }
  ++num_columns_;
}

std::optional<size_t> EventChain::FindRow(const ObjectPair& pair) const {
  const auto it = std::lower_bound(pairs_.begin(), pairs_.end(), pair);
  if (it == pairs_.end() || *it != pair) return std::nullopt;
  return static_cast<size_t>(it - pairs_.begin());
}

EventChain EventChain::Slice(size_t first, size_t end) const {
  if (first > end || end > num_columns_) {
    throw std::out_of_range(
        fmt::format("columns {} to {} of {}", first, end, num_columns_));
  }
  EventChain slice;
  slice.num_columns_ = end - first;
  if (slice.num_columns_ == 0) return slice;
  slice.pairs_ = pairs_;
  const auto from = static_cast<std::ptrdiff_t>(first);
  const auto to = static_cast<std::ptrdiff_t>(end);
  for (const auto& row : rows_) {
    slice.rows_.emplace_back(row.begin() + from, row.begin() + to);
  }
  return slice;
}

EventChain EventChain::RowsOf(const std::string& name) const {
  return RowsWhere([&](size_t row) {
    return pairs_[row].first == name || pairs_[row].second == name;
  });
}

EventChain EventChain::ChangingRows() const {
  return RowsWhere([&](size_t row) {
    const auto& entries = rows_[row];
    return std::any_of(entries.begin(), entries.end(),
                       [&](Relation r) { return r != entries.front(); });
  });
}

EventChain EventChain::DistinctColumns() const {
  EventChain distinct;
  distinct.pairs_ = pairs_;
  distinct.rows_.resize(rows_.size());
  for (size_t column = 0; column < num_columns_; ++column) {
    const bool is_new =
        column == 0 || std::any_of(rows_.begin(), rows_.end(), [&](auto& row) {
          return row[column] != row[column - 1];
        });
    if (!is_new) continue;
    for (size_t row = 0; row < rows_.size(); ++row) {
      distinct.rows_[row].push_back(rows_[row][column]);
    }
    ++distinct.num_columns_;
  }
  return distinct;
}

template <class Predicate>
EventChain EventChain::RowsWhere(Predicate is_wanted) const {
  EventChain chosen;
  chosen.num_columns_ = num_columns_;
  for (size_t row = 0; row < rows_.size(); ++row) {
    if (!is_wanted(row)) continue;
    chosen.pairs_.push_back(pairs_[row]);
    chosen.rows_.push_back(rows_[row]);
  }
  return chosen;
}

EventChain ChainOf(std::span<const KeyFrame> frames) {
  TouchGraph absent;
  for (const KeyFrame& frame : frames) {
    for (const auto& [pair, relation] : frame.segment_relations) {
      absent.emplace(pair, Relation::kAbsent);
    }
  }
  EventChain chain;
  for (const KeyFrame& frame : frames) {
    TouchGraph all = frame.segment_relations;
    all.insert(absent.begin(), absent.end());  // where there is none
    all.insert(frame.relations.begin(), frame.relations.end());
    chain.Append(all);
  }
  return chain;
}

std::string ToText(const EventChain& chain) {
  std::vector<std::string> names;
  size_t width = 0;
  for (const auto& [first, second] : chain.pairs()) {
    names.push_back(first + ", " + second);
    width = std::max(width, names.back().size());
  }
  std::string text;
  for (size_t row = 0; row < chain.num_rows(); ++row) {
    text += fmt::format("{:{}} ", names[row], width);
    for (const Relation relation : chain.Row(row)) {
      text += fmt::format(" {}", static_cast<int>(relation));
    }
    text += '\n';
  }
  return text;
}

}  // namespace cell
