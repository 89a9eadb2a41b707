#include "common/sec/chain_index.h"

#include <algorithm>

namespace cell {

void ChainIndex::AppendEntries(const RelationMatrix& sorted,
                               std::vector<RoleEntries>* entries) {
  for (size_t row = 0; row < sorted.num_rows(); ++row) {
    if (row == 0 || sorted.role(row) != sorted.role(row - 1)) {
      entries->push_back({sorted.role(row)});
    }
    ++entries->back().num_rows;
    for (const uint8_t symbol : sorted.Row(row)) {
      ++entries->back().counts[symbol];
    }
  }
}

void ChainIndex::Add(const RelationMatrix& model) {
  models_.push_back(model.Sorted());
  AppendEntries(models_.back(), &entries_);
  ends_.push_back(entries_.size());
  sizes_.emplace_back(model.num_rows(), model.num_columns());
}

double ChainIndex::Bound(const RelationMatrix& query,
                         const std::vector<RoleEntries>& entries,
                         size_t model) const {
  const auto [rows, columns] = sizes_[model];
  const RoleEntries* theirs =
      entries_.data() + (model == 0 ? 0 : ends_[model - 1]);
  const RoleEntries* end = entries_.data() + ends_[model];
  const auto num_columns =
      std::min(columns, static_cast<uint32_t>(query.num_columns()));
  uint32_t num_equal = 0;
  for (const RoleEntries& mine : entries) {
    while (theirs != end && theirs->role < mine.role) ++theirs;
    if (theirs == end) break;
    if (theirs->role != mine.role) continue;
    uint32_t common = 0;
    for (size_t s = 0; s < RelationMatrix::kNumSymbols; ++s) {
      common += std::min(mine.counts[s], theirs->counts[s]);
    }
    num_equal += std::min(
        common, std::min(mine.num_rows, theirs->num_rows) * num_columns);
  }
  // Rounded as DiceOf() does.
  return 2.0 * num_equal /
         static_cast<double>(query.num_entries() + size_t{rows} * columns);
}

// A query without entries is similar only to a model without entries.
ChainIndex::Match ChainIndex::MostSimilarToNone() const {
  const auto it = std::ranges::find_if(models_, &RelationMatrix::is_empty);
  if (it == models_.end()) return {};
  return {static_cast<size_t>(it - models_.begin()), 1, 0};
}

std::optional<ChainIndex::Match> ChainIndex::MostSimilar(
    const RelationMatrix& query) const {
  if (models_.empty()) return std::nullopt;
  const RelationMatrix sorted = query.Sorted();
  Match best;
  if (query.is_empty()) return MostSimilarToNone();
  std::vector<RoleEntries> entries;
  AppendEntries(sorted, &entries);
  using Candidate = std::pair<double, size_t>;
  std::vector<Candidate> candidates(models_.size());
  for (size_t i = 0; i < models_.size(); ++i) {
    candidates[i] = {Bound(sorted, entries, i), i};
  }
  const auto is_later = [](const Candidate& a, const Candidate& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::ranges::make_heap(candidates, is_later);
  best.similarity = -1;
  while (!candidates.empty() && candidates.front().first >= best.similarity) {
    const size_t model = candidates.front().second;
    std::ranges::pop_heap(candidates, is_later);
    candidates.pop_back();
    const double similarity = similarity_.Between(sorted, models_[model]);
    ++best.num_compared;
    if (similarity > best.similarity ||
        (similarity == best.similarity && model < best.model)) {
      best.similarity = similarity;
      best.model = model;
    }
  }
  return best;
}

}  // namespace cell
