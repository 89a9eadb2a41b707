#pragma once

#include <array>
#include <optional>
#include <vector>

#include "common/sec/chain_alignment.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// What samples of one manipulation have in common (section VI-A): rows and
/// columns with weights. Those that a sample shows gain weight, those that it
/// adds start with a small one; those that stay light are deleted.
class ChainModel {
 public:
  struct Params {
    RowRoles roles = RowRoles::kKept;  ///< which rows may correspond
    double start_weight = 0.1;
    double gain = 0.1;          ///< per sample that shows the row or column
    double least_weight = 0.5;  ///< of those that are not deleted ...
    int trial_samples = 10;     ///< ... after as many samples
  };

  ChainModel(const RelationMatrix& sample, const Params& params);

  /// Takes in a sample that was assigned to this model.
  void Update(const RelationMatrix& sample);
  /// Takes in another model of the same manipulation with all its samples.
  void Merge(const ChainModel& other);

  int num_samples() const { return num_samples_; }
  /// All rows and columns; each entry is what most samples had there, of
  /// equally many the first symbol.
  const RelationMatrix& chain() const { return chain_; }
  /// The rows and columns that at least half of all samples show: noise is left
  /// out without waiting for its deletion.
  RelationMatrix Consensus() const;

 private:
  // A row or column.
  struct Line {
    double weight = 0;
    int num_seen = 0;
    int num_samples = 0;  // since it is known, that one included
  };
  using Votes = std::array<int, RelationMatrix::kNumSymbols>;

  void Absorb(const ChainModel& other);
  void AddVotes(std::optional<size_t> row, std::optional<size_t> column,
                Votes* sum) const;
  void DeleteLightLines();
  void Keep(const std::vector<size_t>& rows,
            const std::vector<size_t>& columns);
  void Elect();

  Params params_;
  int num_samples_ = 1;
  RelationMatrix chain_;
  std::vector<Line> rows_, columns_;
  std::vector<Votes> votes_;  // by rows
};

}  // namespace cell
