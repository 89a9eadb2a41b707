#include "common/sec/chain_model.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace cell {
namespace {

using OptionalLine = std::optional<size_t>;

// A line of the union of two chains, with its index in each.
struct UnitedLine {
  OptionalLine mine, theirs;
};

std::vector<size_t> AllOf(size_t count) {
  std::vector<size_t> lines(count);
  std::iota(lines.begin(), lines.end(), size_t{0});
  return lines;
}

// Lines of both in order, those that correspond as one; of the lines between
// two that correspond, mine come first.
std::vector<UnitedLine> UniteInOrder(const LinePairs& pairs, size_t num_mine,
                                     size_t num_theirs) {
  std::vector<UnitedLine> lines;
  size_t mine = 0, theirs = 0;
  const auto add_up_to = [&](size_t end_mine, size_t end_theirs) {
    while (mine < end_mine) lines.push_back({mine++, std::nullopt});
    while (theirs < end_theirs) lines.push_back({std::nullopt, theirs++});
  };
  for (const auto& [i, j] : pairs) {
    add_up_to(i, j);
    lines.push_back({mine++, theirs++});
  }
  add_up_to(num_mine, num_theirs);
  return lines;
}

// Rows have no order: mine as they are, then those that only the other has.
std::vector<UnitedLine> UniteRows(const LinePairs& pairs, size_t num_mine,
                                  size_t num_theirs) {
  std::vector<UnitedLine> lines;
  for (size_t row = 0; row < num_mine; ++row) {
    lines.push_back({row, std::nullopt});
  }
  std::vector<char> is_known(num_theirs);
  for (const auto& [i, j] : pairs) {
    lines[i].theirs = j;
    is_known[j] = 1;
  }
  for (size_t row = 0; row < num_theirs; ++row) {
    if (!is_known[row]) lines.push_back({std::nullopt, row});
  }
  return lines;
}

template <class T>
std::vector<T> Chosen(const std::vector<T>& all,
                      const std::vector<size_t>& indices) {
  std::vector<T> chosen;
  for (const size_t i : indices) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace

ChainModel::ChainModel(const RelationMatrix& sample, const Params& params)
    : params_(params),
      chain_(sample),
      rows_(sample.num_rows(), {params.start_weight, 1, 1}),
      columns_(sample.num_columns(), {params.start_weight, 1, 1}),
      votes_(sample.num_entries()) {
  for (size_t row = 0; row < sample.num_rows(); ++row) {
    for (size_t column = 0; column < sample.num_columns(); ++column) {
      votes_[row * sample.num_columns() + column][sample.Symbol(row, column)] =
          1;
    }
  }
}

void ChainModel::Update(const RelationMatrix& sample) {
  Absorb(ChainModel(sample, params_));
}

void ChainModel::Merge(const ChainModel& other) {
  Absorb(other);
}

void ChainModel::Absorb(const ChainModel& other) {
  const ChainAlignment alignment =
      AlignChains(chain_, other.chain_, params_.roles);
  const auto rows = UniteRows(alignment.rows, rows_.size(), other.rows_.size());
  const auto columns =
      UniteInOrder(alignment.columns, columns_.size(), other.columns_.size());
  std::vector<uint32_t> roles;
  for (const UnitedLine& row : rows) {
    roles.push_back(row.mine ? chain_.role(*row.mine)
                             : other.chain_.role(*row.theirs));
  }
  std::vector<Votes> votes;
  for (const UnitedLine& row : rows) {
    for (const UnitedLine& column : columns) {
      votes.emplace_back();
      AddVotes(row.mine, column.mine, &votes.back());
      other.AddVotes(row.theirs, column.theirs, &votes.back());
    }
  }
  const auto weigh = [&](const auto& united, const auto& mine,
                         const auto& theirs) {
    std::vector<Line> lines;
    for (const UnitedLine& line : united) {
      lines.push_back(line.mine ? mine[*line.mine] : theirs[*line.theirs]);
      if (!line.mine) continue;
      lines.back().num_samples += other.num_samples_;
      if (!line.theirs) continue;
      lines.back().weight += params_.gain * theirs[*line.theirs].num_seen;
      lines.back().num_seen += theirs[*line.theirs].num_seen;
    }
    return lines;
  };
  rows_ = weigh(rows, rows_, other.rows_);
  columns_ = weigh(columns, columns_, other.columns_);
  votes_ = std::move(votes);
  chain_ = RelationMatrix(std::move(roles), columns_.size());
  num_samples_ += other.num_samples_;
  DeleteLightLines();
  Elect();
}

// Adds the votes on an entry, if this model has its row and column.
void ChainModel::AddVotes(std::optional<size_t> row,
                          std::optional<size_t> column, Votes* sum) const {
  if (!row || !column) return;
  const Votes& more = votes_[*row * columns_.size() + *column];
  for (size_t s = 0; s < sum->size(); ++s) (*sum)[s] += more[s];
}

void ChainModel::DeleteLightLines() {
  const auto heavy = [&](const std::vector<Line>& lines) {
    std::vector<size_t> kept = AllOf(lines.size());
    std::erase_if(kept, [&](size_t i) {
      return lines[i].num_samples >= params_.trial_samples &&
             lines[i].weight < params_.least_weight;
    });
    return kept;
  };
  const auto rows = heavy(rows_);
  const auto columns = heavy(columns_);
  if (rows.empty() || columns.empty()) return;  // nothing in common: keep all
  Keep(rows, columns);
}

void ChainModel::Keep(const std::vector<size_t>& rows,
                      const std::vector<size_t>& columns) {
  std::vector<Votes> votes;
  for (const size_t row : rows) {
    for (const size_t column : columns) {
      votes.push_back(votes_[row * columns_.size() + column]);
    }
  }
  votes_ = std::move(votes);
  chain_ = chain_.Select(rows, columns);
  rows_ = Chosen(rows_, rows);
  columns_ = Chosen(columns_, columns);
}

void ChainModel::Elect() {
  for (size_t row = 0; row < rows_.size(); ++row) {
    for (size_t column = 0; column < columns_.size(); ++column) {
      const Votes& votes = votes_[row * columns_.size() + column];
      const auto winner = std::ranges::max_element(votes) - votes.begin();
      chain_.Set(row, column, static_cast<uint8_t>(winner));
    }
  }
}

RelationMatrix ChainModel::Consensus() const {
  const auto frequent = [&](const std::vector<Line>& lines) {
    std::vector<size_t> kept = AllOf(lines.size());
    std::erase_if(
        kept, [&](size_t i) { return 2 * lines[i].num_seen < num_samples_; });
    return kept;
  };
  return chain_.Select(frequent(rows_), frequent(columns_));
}

}  // namespace cell
