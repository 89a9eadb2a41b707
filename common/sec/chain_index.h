#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/sec/typed_similarity.h"

namespace cell {

/// Finds the model that TypedSimilarity says is most similar, without comparing
/// all of them. With rows of role r and the number of their entries h_r(s) with
/// symbol s, no alignment has more equal entries than
///
///   sum over r of min(sum over s of min(h_r(s), h'_r(s)),
///                     min(rows_r, rows'_r) min(columns, columns')),
///
/// which bounds the similarity. Models are compared in the order of this
/// bound until it is below the best similarity found.
///
/// Cost per query: roles per model and query for each bound, and as many
/// comparisons as models whose bound is above the best similarity.
class ChainIndex {
 public:
  struct Match {
    size_t model = 0;       ///< in the order of Add(), the first of equals
    double similarity = 0;  ///< TypedSimilarity
    size_t num_compared = 0;
  };

  /// All roles of models and queries are numbered by one table.
  void Add(const RelationMatrix& model);
  size_t size() const { return models_.size(); }
  const RelationMatrix& model(size_t i) const { return models_.at(i); }

  /// nullopt if there are no models.
  std::optional<Match> MostSimilar(const RelationMatrix& query) const;

 private:
  // The entries of the rows of one role.
  struct RoleEntries {
    uint32_t role = 0;
    uint32_t num_rows = 0;
    uint32_t counts[RelationMatrix::kNumSymbols] = {};
  };
  static void AppendEntries(const RelationMatrix& sorted,
                            std::vector<RoleEntries>* entries);
  Match MostSimilarToNone() const;
  double Bound(const RelationMatrix& query,
               const std::vector<RoleEntries>& entries, size_t model) const;

  TypedSimilarity similarity_;
  std::vector<RelationMatrix> models_;                // sorted
  std::vector<RoleEntries> entries_;                  // of all models
  std::vector<size_t> ends_;                          // of each model's entries
  std::vector<std::pair<uint32_t, uint32_t>> sizes_;  // rows, columns
};

}  // namespace cell
